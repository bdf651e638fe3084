"""What charts call things, for people who do not know the names of this library and of its benchmarks."""

import re

PRECISIONS = {"f32": "float", "f64": "double", "mixed": "float moved in double"}
INSTRUCTION_SETS = {"avx512": "AVX-512", "avx2": "AVX2", "sse2": "SSE2", "neon64": "NEON", "scalar": "no vectors"}
COMPILERS = {"gcc": "GCC", "clang": "Clang"}
FLAGS = {"x86-64": "SSE2", "x86-64-v3": "AVX2", "native": "-march=native", "native512": "-march=native, 512 bits"}
RIVALS = {"eigen": "Eigen", "glm": "GLM", "glm-dualquat": "GLM, dual quaternions", "cglm": "cglm",
          "stream": "loop as in DirectXMath", "libm": "one at a time, C library",
          "two-passes": "Motorway, in two calls", "six-slerps": "Motorway, in six calls of slerp",
          "poses": "Motorway, poses made beforehand"}

# The operand of apply: what is moved.
MOVED = {"point": "points", "vertex": "vertices", "direction": "directions", "tangent": "tangents",
         "vector": "spheres and planes", "line": "lines", "motor": "motors", "bivector": "twists"}
PAIRINGS = {"one": "all by one motor", "each": "each by a motor of its own", "grid": "all by each of many motors",
            "indexed": "each by a motor of a palette", "motion": "all along a motion"}
# Other verbs: what comes out, and what a call has a number of.
MADE = {"compose_motor_hierarchy": ("Poses of skeletons", "skeletons"), "compose": ("Products of motors", "motors"),
        "reverse": ("Reverses of motors", "motors"), "inverse": ("Inverses of motors", "motors"),
        "normalize": ("Motors made unit", "motors"), "ratio": ("Motors from pose to pose", "motors"),
        "exp": ("Exponentials of generators", "motors"), "log": ("Logarithms of motors", "motors"),
        "sqrt": ("Square roots of motors", "motors"), "power": ("Powers of motors", "motors"),
        "slerp": ("Screws between two poses", "poses"), "nlerp": ("Blends of two poses", "poses"),
        "blend": ("Weighted sums of motors", "motors"), "sample": ("Poses of motions", "poses"),
        "compile": ("Motions compiled", "motions")}


def title(kernel: str) -> str:
    """Points moved, all by one motor (apply_point_one)."""
    return f"{_sentence(kernel)} ({kernel})"


def elements(kernel: str) -> str:
    """What a call has a number of: points."""
    apply = re.match(r"apply_([a-z]+)_", kernel)
    if apply:
        return MOVED.get(apply[1], "elements")
    if kernel.startswith("convert_"):
        return "conversions"
    return next((noun for verb, (_, noun) in MADE.items() if kernel.startswith(verb)), "elements")


def layout(name: str) -> str:
    """How they lie in memory."""
    if name == "soa":
        return "An array for each coordinate"
    if name == "aos-columns":
        return "Packed, results element by element"
    size = name[len("aos"):]
    return f"In structures of {size} bytes" if size else "Packed, one after the other"


def precision(name: str) -> str:
    return PRECISIONS.get(name, name)


def instruction_set(name: str) -> str:
    return f"Motorway, {INSTRUCTION_SETS.get(name, name)}"


def baseline(name: str) -> str:
    """plain-gcc-x86-64-v3 is a loop in C, compiled by GCC for AVX2."""
    if not name.startswith("plain-"):
        return RIVALS.get(name, name)
    _, compiler, flags = name.split("-", 2)
    return f"loop in C, {COMPILERS.get(compiler, compiler)}, {FLAGS.get(flags, flags)}"


def _sentence(kernel: str) -> str:
    apply = re.match(r"apply_([a-z]+)_([a-z]+)", kernel)
    if apply:
        return f"{elements(kernel).capitalize()} moved, {PAIRINGS.get(apply[2], apply[2])}"
    convert = re.match(r"convert_(.+)_to_(.+)_each", kernel)
    if convert:
        return " to ".join(part.replace("_", " ") for part in convert.groups()).capitalize()
    return next((words for verb, (words, _) in MADE.items() if kernel.startswith(verb)), kernel.replace("_", " "))
