"""Rewriting expressions so that they cost less: common sums, collecting by symbols, and the choice of a form."""

from __future__ import annotations

from collections import Counter
from dataclasses import dataclass
from fractions import Fraction
from itertools import combinations
from typing import Dict, FrozenSet, Mapping, Sequence, Tuple, Union

from expression import (
    Expansion,
    Node,
    as_term,
    component,
    divide,
    expand,
    from_polynomial,
    function,
    multiply,
    named,
    root,
    sum_of,
)
from plan import Plan, make_plan, reachable
from polynomial import ONE, Polynomial, Quotient

# What is known of symbols: of a polynomial that it is their square, of a quotient that it is the symbol itself.
Relations = Mapping[str, Union[Polynomial, Quotient]]


@dataclass(frozen=True)
class Form:
    """One way of computing a kernel: an expression an output."""

    name: str
    outputs: Tuple[Node, ...]


@dataclass(frozen=True)
class Choice:
    """The form that was chosen, its plan, and the cost of every form that was considered."""

    form: Form
    plan: Plan
    considered: Tuple[Tuple[str, Plan], ...]


def choose(forms: Sequence[Form], element_symbols: FrozenSet[str], relations: Relations) -> Choice:
    """The cheapest of several forms, after proving that they are all equal (modulo the relations)."""
    prove_equal(forms, relations)
    plans = []
    for form in forms:
        form = share_common_sums(form, element_symbols)
        plans.append((form, make_plan(form.outputs, element_symbols)))
    best = min(range(len(plans)), key=lambda k: (plans[k][1].cost, k))
    return Choice(*plans[best], considered=tuple((form.name, plan) for form, plan in plans))


def prove_equal(forms: Sequence[Form], relations: Relations) -> None:
    """Raise unless every form is exactly equal to the first."""
    definition = [expand(output) for output in forms[0].outputs] if len(forms) > 1 else []
    for form in forms[1:]:
        for k, output in enumerate(form.outputs):
            if not definition[k].equals(expand(output), dict(relations)):
                raise ArithmeticError(f'form "{form.name}" differs from "{forms[0].name}" in output {k}')


def linear_coefficients(n: Node, names: Sequence[str]) -> Dict[str, Node]:
    """The coefficients of each of the named symbols in a polynomial that is linear in them, and of 1 under ""."""
    expansion: Expansion = expand(n)
    if expansion.factors:
        raise ValueError("linear_coefficients takes a polynomial")
    result = {}
    for monomial, coefficient in expansion.numerator.collect(names).items():
        if monomial != ONE and (len(monomial) > 1 or monomial[0][1] > 1):
            raise ValueError(f"not linear: {monomial}")
        result[monomial[0][0] if monomial else ""] = from_polynomial(coefficient)
    return result


# ------------------------------------------------------------------------------------------------- common sums


def share_common_sums(form: Form, element_symbols: FrozenSet[str]) -> Form:
    """While it lowers the cost, compute a pair of terms that several sums have in common once.

    Greedy: in each round the pair that saves most is taken.
    """
    best = make_plan(form.outputs, element_symbols).cost
    while True:
        trials = []
        for pair in common_pairs(form.outputs):
            trial = replace_pair(form, pair)
            trials.append((make_plan(trial.outputs, element_symbols).cost, len(trials), trial))
        if not trials or min(trials)[0] >= best:
            return form
        best, _, form = min(trials)


def common_pairs(outputs: Sequence[Node]):
    """Pairs of terms, up to a common factor, that occur in more than one sum: ((factors, factors, ratio), ...)."""
    counts: Counter = Counter()
    for n in reachable(outputs):
        if n.kind == "sum" and len(n.terms) > 2:
            counts.update((f, g, d / c) for (c, f), (d, g) in combinations(n.terms, 2))
        elif n.kind == "sum" and len(n.terms) == 2:
            (c, f), (d, g) = n.terms
            counts[f, g, d / c] += 1
    return [pair for pair, count in counts.items() if count > 1]


def replace_pair(form: Form, pair) -> Form:
    """The form with one pair of terms, wherever it occurs, made a node of its own."""
    first, second, ratio = pair
    shared = sum_of([(Fraction(1), first), (ratio, second)])
    rebuilt: Dict[Node, Node] = {}

    def rebuild(n: Node) -> Node:
        if n not in rebuilt:
            rebuilt[n] = rewrite(n)
        return rebuilt[n]

    def rewrite(n: Node) -> Node:
        if n.kind in ("symbol", "precise") or n is shared:
            return n
        if n.kind == "function":
            return function(n.name, *map(rebuild, n.operands))
        if n.kind == "component":
            return component(rebuild(n.operands[0]), n.name)
        if n.kind == "named":
            return named(n.name, rebuild(n.operands[0]))
        if n.kind == "quotient":
            return divide(*map(rebuild, n.operands))
        if n.kind == "root":
            return root(rebuild(n.operands[0]))
        coefficients = {factors: c for c, factors in n.terms}
        c = coefficients.get(first)
        matches = c is not None and coefficients.get(second) == c * ratio
        terms = [t for t in n.terms if not (matches and t[1] in (first, second))]
        parts = [product(coefficient, [rebuild(f) for f in factors]) for coefficient, factors in terms]
        if matches:
            parts.insert(0, product(c, [shared]))
        return sum_of([as_term(part) for part in parts])

    return Form(form.name, tuple(rebuild(output) for output in form.outputs))


def product(coefficient: Fraction, factors: Sequence[Node]) -> Node:
    result = sum_of([(coefficient, ())])
    for factor in factors:
        result = multiply(result, factor)
    return result
