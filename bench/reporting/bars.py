"""How high the library has set its bars: ratios of medians within one run, of f32 on one thread if not said."""

from dataclasses import dataclass
from typing import Callable, Iterable, List, Optional

from .results import Results, Row


@dataclass(frozen=True)
class Bar:
    shape: str
    against: str
    asked: float
    reached: float
    best: str = ""  # who that was, of several

    @property
    def rival(self) -> str:
        return f"{self.against} ({self.best})" if self.best else self.against

    @property
    def passed(self) -> bool:
        return self.reached >= self.asked


Maker = Callable[[Results], Iterable[Optional[Bar]]]


def bars(results: Results) -> List[Bar]:
    """Those for which the run has measured both sides."""
    makers: List[Maker] = [_one_packed, _one_packed_few, _one_strided, _one_soa, _one_beyond_caches, _each_soa,
                           _each_packed, _grid, _avx2, _f64, _threads, _group_limits, _group_rivals, _group_packed,
                           _group_f64, _conversions, _skeletons, _motions_additive, _motions_multiplicative,
                           _motions_mesh, _motions_compiled]
    return [bar for maker in makers for bar in maker(results) if bar]


def _strided(precision: str) -> str:
    return {"f32": "aos32", "f64": "aos64"}[precision]


def _best(rows: Iterable[Row]) -> Optional[Row]:
    return max(rows, key=lambda row: row.items_per_second, default=None)


def _plain(results: Results, kernel: str, layout: str, count: int, flags: Optional[str] = None) -> Optional[Row]:
    """The best plain loop, of any compiler, at some flags or at any."""
    return _best(row for row in results.baselines(kernel, layout, "f32", count)
                 if row.is_plain and flags in (None, row.rival.split("-", 2)[2]))


def _ours(results: Results, kernel: str, layout: str, count: int, precision: str = "f32",
          isa: Optional[str] = None) -> Optional[Row]:
    return results.find(kernel, layout, precision, count, isa or results.isas[0])


def _ratio(ours: Optional[Row], other: Optional[Row], asked: float, against: str) -> Optional[Bar]:
    if not ours or not other:
        return None
    return Bar(ours.name, against, asked, ours.items_per_second / other.items_per_second,
               other.rival or "")


def _part(row: Optional[Row], seconds: Optional[float], asked: float, against: str) -> Optional[Bar]:
    return Bar(row.name, against, asked, seconds / row.seconds) if row and seconds else None


def _one_packed(results: Results):
    ours = _ours(results, "apply_point_one", "aos", 1024)
    for flags, asked in ((None, 1.15), ("native", 2), ("x86-64-v3", 3), ("x86-64", 5)):
        yield _ratio(ours, _plain(results, "apply_point_one", "aos", 1024, flags), asked,
                     f"best plain loop at {flags or 'any flags'}")


def _one_packed_few(results: Results):
    yield _ratio(_ours(results, "apply_point_one", "aos", 64), _plain(results, "apply_point_one", "aos", 64), 1.0,
                 "best plain loop at any flags")


def _one_strided(results: Results):
    layout = _strided("f32")
    yield _ratio(_ours(results, "apply_point_one", layout, 1024), _plain(results, "apply_point_one", layout, 1024),
                 1.15, "best plain loop at any flags")


def _one_soa(results: Results):
    ours = _ours(results, "apply_point_one", "soa", 1024)
    yield _ratio(ours, _plain(results, "apply_point_one", "soa", 1024), 1.3, "best plain loop at any flags")
    limit = results.part_of_limit(ours) if ours else None
    if limit:
        yield Bar(ours.name, "the limit that binds: " + limit[1], 0.7, limit[0])


def _one_beyond_caches(results: Results):
    largest = max((row.count for row in results.rows), default=0)
    if largest < 8_000_000:
        return
    for layout in ("aos", _strided("f32"), "soa"):
        ours = _ours(results, "apply_point_one", layout, largest)
        yield _part(ours, results.copy_seconds(ours) if ours else None, 0.95, "limit_copy of the same bytes")


def _each_soa(results: Results):
    ours = _ours(results, "apply_point_each", "soa", 1024)
    rivals = (results.find("apply_point_each", layout, "f32", 1024, rival="eigen") for layout in ("aos", "soa"))
    yield _ratio(ours, _best(row for row in rivals if row), 1.6, "Eigen, the better of aos and soa")
    yield _part(ours, results.fma_seconds(ours) if ours else None, 0.8, "limit_fma")


def _each_packed(results: Results):
    yield _ratio(_ours(results, "apply_point_each", "aos", 1024), _ours(results, "apply_point_each", "soa", 1024),
                 0.65, "the same in soa")


def _grid(results: Results):
    # 64 poses of as many points.
    for row in results.rows:
        if (row.kernel, row.precision, row.count, row.isa) == ("apply_point_grid", "f32", 65536, results.isas[0]):
            rate = results.memory["fill"].at(row.span_written)
            yield _part(row, row.span_written / rate if rate else None, 0.9, "limit_fill of the bytes written")


def _avx2(results: Results):
    for layout in ("aos", _strided("f32"), "soa"):
        yield _ratio(_ours(results, "apply_point_one", layout, 1024, isa="avx2"),
                     _plain(results, "apply_point_one", layout, 1024, "x86-64-v3"), 1.15,
                     "best plain loop at x86-64-v3")


def _f64(results: Results):
    # 256 points of either precision are in the first cache.
    for kernel in ("apply_point_one", "apply_point_each"):
        for layout in ("aos", "aos*", "soa"):
            f64, f32 = (_ours(results, kernel, layout.replace("aos*", _strided(precision)), 256, precision)
                        for precision in ("f64", "f32"))
            yield _ratio(f64, f32, 0.5 * 0.85, "the same in f32")


def _threads(results: Results):
    for kernel in ("apply_point_one", "apply_point_each"):
        for layout in ("aos", "soa"):
            two = results.find(kernel, layout, "f32", 1024, results.isas[0], threads=2)
            yield _ratio(two, _ours(results, kernel, layout, 1024), 1.8, "one thread")


# ----------------------------------------------------------------------------------------- the group of motors

GROUP = ("compose_motor_each", "exp_motor_each", "log_motor_each-unit", "slerp_motor_each")


def _group_limits(results: Results):
    for kernel, asked in zip(GROUP, (0.8, 0.6, 0.6, 0.6)):
        ours = _ours(results, kernel, "soa", 1024)
        yield _part(ours, results.fma_seconds(ours) if ours else None, asked, "limit_fma")


def _group_rivals(results: Results):
    for kernel, rival, asked in (("exp_motor_each", "libm", 12), ("log_motor_each-unit", "libm", 20),
                                 ("slerp_motor_each", "libm", 20), ("slerp_motor_each", "eigen", 3)):
        other = results.find(kernel.replace("-unit", ""), "aos", "f32", 1024, rival=rival)
        yield _ratio(_ours(results, kernel, "soa", 1024), other, asked, "packed, one after the other")


def _group_packed(results: Results):
    for kernel in GROUP:
        yield _ratio(_ours(results, kernel, "aos", 1024), _ours(results, kernel, "soa", 1024), 0.65,
                     "the same in soa")


def _group_f64(results: Results):
    for kernel in GROUP:
        yield _ratio(_ours(results, kernel, "soa", 1024, "f64"), _ours(results, kernel, "soa", 1024), 0.5 * 0.8,
                     "the same in f32")


def _conversions(results: Results):
    for row in results.rows:
        wanted = (row.precision, row.count, row.isa) == ("f32", 65536, results.isas[0])
        if wanted and row.kernel.startswith("convert_"):
            yield _part(row, results.copy_seconds(row), 0.8, "limit_copy of the same bytes")


def _skeletons(results: Results):
    kernel = "compose_motor_hierarchy"
    yield _ratio(_ours(results, kernel, "soa", 1000), _plain(results, kernel, "aos", 1000), 4,
                 "best plain loop, skeleton after skeleton")


# ------------------------------------------------------------------------------------------------------- motions

def _motions_additive(results: Results):
    for kernel in ("sample_additive_one", "sample_additive_each_shared"):
        ours = _ours(results, kernel, "soa", 1024)
        yield _part(ours, results.fma_seconds(ours) if ours else None, 0.6, "limit_fma")
        limit = results.limit_seconds(ours) if ours else None
        if limit and limit[1] != "fma":  # many motions are many controls to read
            yield _part(ours, limit[0], 0.6, "the limit that binds: " + limit[1])


def _motions_multiplicative(results: Results):
    for kernel in ("sample_multiplicative_one", "sample_multiplicative_each"):
        ours = _ours(results, kernel, "soa", 1024)
        yield _ratio(ours, results.find(kernel, "aos", "f32", 1024, rival="libm"), 20, "packed, one after the other")
        slerps = results.find(kernel, "soa", "f32", 1024, rival="six-slerps")
        yield _ratio(ours, slerps, 1 / 1.2, "slerp in six calls")


def _motions_mesh(results: Results):
    kernel = "apply_point_motion"
    for count in {row.count for row in results.rows if row.kernel == kernel}:
        for layout in ("aos", "soa"):
            poses = results.find(kernel, layout, "f32", count, rival="poses")
            yield _ratio(_ours(results, kernel, layout, count), poses, 0.85, "apply_point_grid")


def _motions_compiled(results: Results):
    for row in results.rows:
        if row.kernel.startswith("compile_") and (row.precision, row.isa) == ("f32", results.isas[0]):
            yield _part(row, 1e-3, 1, "a millisecond")
