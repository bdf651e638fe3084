"""The symbols that the proofs are about: general elements of the algebra, with a variable for every coefficient.

An equation between elements with polynomial coefficients is decided by `==`. Where variables are bound by
relations (the cosine and sine of one angle, the coordinates of a unit vector) both sides are first brought to
the normal form of `modulo`; so an inequality there is a proof as well.
"""

from fractions import Fraction

from algebra import Multivector, e, multivector
from polynomial import Polynomial, variables

MOTOR = ("", "12", "13", "23", "1i", "2i", "3i", "123i")  # equation (3) of Hunt et al.
SPACE = ("1", "2", "3")
HALF = Fraction(1, 2)

E123 = e("123")  # ω with a hat in Hunt et al.
INFINITY = e("i")  # n in Wareham and Lasenby

# The cosine and sine of one angle, and a unit vector a with the unit bivector of the plane normal to it.
c, s = variables("c s")
a1, a2, a3 = variables("a1 a2 a3")
AXIS = a1 * e("1") + a2 * e("2") + a3 * e("3")
UNIT = {"s": 1 - c * c, "a3": 1 - a1 * a1 - a2 * a2}


def general(name: str, blades) -> Multivector:
    """The general linear combination of the blades: general("t", "12") is t1 e1 + t2 e2."""
    return Multivector({blade: Polynomial.variable(f"{name}{blade or 's'}") for blade in blades})


def motor(name: str) -> Multivector:
    """The general even-grade 0-free element."""
    return general(name, MOTOR)


def unit_motor(name: str):
    """The general motor with S̄S = 1, and its relation: a unit rotation part times a translation.

    That every such motor has this form is shown by test_hunt's test_normalised_motors_are_rotation_times_translation.
    """
    rotation = general(name, MOTOR[:4])
    last = f"{name}23"
    rest = rotation.only(("", "12", "13"))
    relation = {last: 1 - sum(x * x for x in rest.parts.values())}
    return rotation * translation(general(f"{name}t", SPACE)), relation


def translation(t: Multivector) -> Multivector:
    """Lemma 3.10 of Hunt et al.: 1 + ½ t e∞."""
    return 1 + HALF * t * INFINITY


def point(p: Multivector) -> Multivector:
    """The embedding E of a vector of Euclidean space: e0 + p."""
    return e("0") + p


def null_point(p: Multivector) -> Multivector:
    """The embedding E_1, corrected: e0 + p + ½ p² e∞."""
    return e("0") + p + HALF * p * p * INFINITY


def modulo(a, relations) -> Multivector:
    """The normal form under relations, each of which gives the square of one variable."""
    return multivector(a).map(lambda x: Polynomial.of(x).reduce(relations))


def substituted(a: Multivector, values) -> Multivector:
    """The element with variables replaced by polynomials or numbers."""
    return a.map(lambda x: Polynomial.of(x).substitute(values))


def differentiated(a: Multivector, rates) -> Multivector:
    """The derivative of the element when each variable changes at its rate, and the others not at all.

    With rates {"y": 1, "c": -s, "s": c} these are functions of y, and c and s are its cosine and sine.
    """

    def rate_of(polynomial):
        total = Polynomial()
        for monomial, coefficient in Polynomial.of(polynomial).terms.items():
            for name, exponent in monomial:
                if name in rates:
                    lower = {**dict(monomial), name: exponent - 1}
                    factors = tuple((n, k) for n, k in sorted(lower.items()) if k)
                    total = total + Polynomial({factors: coefficient * exponent}) * rates[name]
        return total

    return a.map(rate_of)
