// Descriptions of motions made into compiled ones: checked as a whole, and only then written.
#include "compiled.h"
#include "scalar_motor.h"

#include <algorithm>
#include <cmath>
#include <cstring>

namespace motorway {

namespace {

using motor = scalar_motor<double>;
using bivector = scalar_bivector<double>;

// Some a span, so that most have no knot inside; and few enough for floats to tell them apart.
constexpr std::size_t cells_per_span = 4, most_cells = 65536;

// ----------------------------------------------------------------------------------------------------- controls

// The controls of one motion, in the order of its timeline and with the signs that it takes them with.
template <class T> class control_reader {
    const motion_of<T> &motion;
    const timeline<T> &times;
    std::size_t first;
    bool keep_signs;
    motor before;

public:
    control_reader(const motion_of<T> &of, const timeline<T> &along, std::size_t number, unsigned flags)
        : motion(of), times(along), first(number * of.control_count), keep_signs(flags & MW_KEEP_SIGNS),
          before(has_generators(of.kind) && of.base ? load_motor<double>(*of.base) : motor{1, 0, 0, 0, 0, 0, 0, 0})
    {
    }

    // To be called with k = 0, 1, ... An additive motion begins with its first control as it is.
    motor next(std::size_t k)
    {
        motor here = load_motor<double>(motion.controls[first + times.source(k)]);
        const bool is_start = k == 0 && !has_generators(motion.kind);
        if (!keep_signs && !is_start && rotations_dot(here, before) < 0)
            here = here * -1.0;
        before = here;
        return motion.weights ? here * double(motion.weights[times.source(k)]) : here;
    }
};

// A motor normalised, or as it is if it is normalised to rounding: its bits are then the caller's.
template <class T> motor unit_of(const motor &m)
{
    const double tolerance = 8 * double(std::numeric_limits<T>::epsilon());
    const double terms[] = {m.s * m.w, -m.b12 * m.b3i, m.b13 * m.b2i, -m.b23 * m.b1i};
    double half_beta = 0, magnitude = 0;
    for (double term : terms)
        half_beta += term, magnitude += std::fabs(term);
    const bool is_unit = std::fabs(alpha(m) - 1) <= tolerance && std::fabs(half_beta) <= tolerance * magnitude;
    return is_unit ? m : normalized(m);
}

template <class T> void write_row(const motor &m, T *row)
{
    const double numbers[] = {m.s, m.b12, m.b13, m.b23, m.b1i, m.b2i, m.b3i, m.w};
    for (int n = 0; n < 8; ++n)
        row[n] = static_cast<T>(numbers[n]);
}
template <class T> void write_row(const bivector &b, T *row)
{
    write_row(motor{0, b.b12, b.b13, b.b23, b.b1i, b.b2i, b.b3i, 0}, row);
}

// ------------------------------------------------------------------------------------------------ vanishing blends

// The rotations of the controls of a span, weighted: a blend vanishes where their sum does.
struct quaternion {
    double c[4];
};
double dot(const quaternion &a, const quaternion &b)
{
    return a.c[0] * b.c[0] + a.c[1] * b.c[1] + a.c[2] * b.c[2] + a.c[3] * b.c[3];
}

// Whether all are on one side of a plane through the origin, which the mean of their directions is normal to: then no
// sum with positive weights vanishes.
bool are_on_one_side(const quaternion *q, std::size_t count)
{
    quaternion mean{};
    for (std::size_t k = 0; k < count; ++k) {
        const double inverse = 1 / square_root(dot(q[k], q[k]));
        for (int n = 0; n < 4; ++n)
            mean.c[n] += inverse * q[k].c[n];
    }
    const double length = square_root(dot(mean, mean));
    for (std::size_t k = 0; k < count; ++k)
        if (!(dot(q[k], mean) > 1e-3 * length * square_root(dot(q[k], q[k]))))
            return false;
    return true;
}

// Whether the Bézier curve of these points comes closer to the origin than that, by halving it until it is clear. In
// place: `q` is spoilt.
bool comes_near_zero(quaternion *q, std::size_t count, double distance, int halvings)
{
    // The ends are on the curve. They come first: the direction of what is all but zero says nothing about a side.
    if (std::min(dot(q[0], q[0]), dot(q[count - 1], q[count - 1])) <= distance * distance)
        return true;
    if (are_on_one_side(q, count))
        return false;
    if (halvings == 0)
        return true; // a piece as short as that, and still around the origin
    quaternion left[MW_MAX_DEGREE + 1];
    for (std::size_t r = 0; r < count; ++r) {
        left[r] = q[0];
        for (std::size_t k = 0; k + 1 < count - r; ++k)
            for (int n = 0; n < 4; ++n)
                q[k].c[n] = (q[k].c[n] + q[k + 1].c[n]) / 2;
    }
    // What is left in q, from its end to its start, is the second half.
    return comes_near_zero(left, count, distance, halvings - 1) || comes_near_zero(q, count, distance, halvings - 1);
}

// The Bézier points of a span: each is the blossom of the span's ends, so many times the one and the other.
template <class T>
void write_bezier_points(const timeline<T> &times, std::size_t span, const quaternion *control, quaternion *bezier)
{
    const std::size_t d = times.degree;
    const double begin = double(times.knot(span)), end = double(times.knot(span + 1));
    for (std::size_t ends = 0; ends <= d; ++ends) {
        quaternion level[MW_MAX_DEGREE + 1];
        std::copy_n(control, d + 1, level);
        for (std::size_t r = d; r > 0; --r) {
            const double t = r <= ends ? end : begin;
            for (std::size_t k = 0; k < r; ++k) {
                const double left = double(times.knot(span + 1 + k - r)), right = double(times.knot(span + 1 + k));
                const double a = (t - left) / (right - left);
                for (int n = 0; n < 4; ++n)
                    level[k].c[n] += a * (level[k + 1].c[n] - level[k].c[n]);
            }
        }
        bezier[ends] = level[0];
    }
}

// Half of the digits are lost where controls cancel to the square root of epsilon.
template <class T>
bool blend_vanishes(const timeline<T> &times, std::size_t span, const quaternion *control)
{
    if (are_on_one_side(control, times.degree + 1))
        return false;
    double largest = 0;
    for (std::size_t k = 0; k <= times.degree; ++k)
        largest = std::max(largest, square_root(dot(control[k], control[k])));
    quaternion bezier[MW_MAX_DEGREE + 1];
    write_bezier_points(times, span, control, bezier);
    return comes_near_zero(bezier, times.degree + 1, largest * square_root(std::numeric_limits<T>::epsilon()), 40);
}

template <class T>
mw_status check_blends(const motion_of<T> &motion, const timeline<T> &times, unsigned flags, std::size_t *where)
{
    for (std::size_t m = 0; m < number_of_motions(motion.motion_count); ++m) {
        control_reader<T> controls(motion, times, m, flags);
        quaternion window[MW_MAX_DEGREE + 1]; // those of the span that ends with the control read last
        for (std::size_t k = 0; k < times.control_count; ++k) {
            const motor control = controls.next(k);
            if (k > times.degree)
                std::copy(window + 1, window + times.degree + 1, window);
            window[std::min(k, times.degree)] = {{control.s, control.b12, control.b13, control.b23}};
            if (k >= times.degree && !times.is_empty(k - 1) && blend_vanishes(times, k - 1, window)) {
                *where = m * motion.control_count + times.source(k - times.degree);
                return MW_ERROR_VANISHING;
            }
        }
    }
    return MW_OK;
}

template <class T> mw_status check_controls(const motion_of<T> &motion, unsigned flags, std::size_t *where)
{
    for (std::size_t k = 0; k < number_of_motions(motion.motion_count) * motion.control_count; ++k) {
        *where = k;
        const T *const control = &motion.controls[k].s;
        if (is_degenerate(control))
            return MW_ERROR_DEGENERATE_MOTOR;
        if (motion.weights) {
            const T weight = motion.weights[k % motion.control_count];
            const T weighted[] = {weight * control[0], weight * control[1], weight * control[2], weight * control[3]};
            if (is_degenerate(weighted))
                return MW_ERROR_WEIGHTS;
        }
    }
    *where = 0;
    if (has_generators(motion.kind) && motion.base && is_degenerate(&motion.base->s))
        return MW_ERROR_DEGENERATE_MOTOR;
    return motion.kind == MW_MOTION_ADDITIVE ? check_blends<T>(motion, timeline<T>(motion), flags, where) : MW_OK;
}

// -------------------------------------------------------------------------------------------------------- writing

template <class T> compiled_header header_of(const motion_of<T> &motion)
{
    const timeline<T> times(motion);
    std::size_t spans = 0;
    for (std::size_t j = times.degree - 1; j + 1 < times.control_count; ++j)
        spans += !times.is_empty(j);
    compiled_header header{};
    header.magic = compiled_magic;
    header.scalar_size = sizeof(T);
    header.kind = static_cast<std::uint32_t>(motion.kind);
    header.degree = static_cast<std::uint32_t>(times.degree);
    header.motion_count = number_of_motions(motion.motion_count);
    header.control_count = times.control_count;
    header.span_count = spans;
    header.begin = double(times.begin());
    header.end = double(times.end());
    header.cell_count = std::min(cells_per_span * spans, most_cells);
    header.cells_per_unit = double(T(double(header.cell_count) / (header.end - header.begin)));
    if (!std::isfinite(header.cells_per_unit)) // a domain so short that no parameter is near another
        header.cell_count = 1, header.cells_per_unit = 0;
    return header;
}

// The inverse of the length of a span, rounded so that the length times it is not below 1.
template <class T> T inverse_of(T length)
{
    const T inverse = T(1) / length;
    return inverse * length < 1 ? next_above(inverse) : inverse;
}

template <class T> void write_span(const timeline<T> &times, std::size_t span, T *out)
{
    const T begin = times.knot(span), end = times.knot(span + 1);
    *out++ = begin;
    *out++ = inverse_of(end - begin);
    for (std::size_t r = 2; r <= times.degree; ++r)
        for (std::size_t k = 0; k < r; ++k) {
            const double left = double(times.knot(span + 1 + k - r)), right = double(times.knot(span + 1 + k));
            const T factor = T((double(end) - double(begin)) / (right - left));
            // The ratio is exactly 1 at the end of the span if the right knot is there, and 0 at its start likewise.
            *out++ = factor;
            *out++ = right == double(end) ? T(1) - factor : T((double(begin) - left) / (right - left));
        }
}

template <class T> void write_spans(const compiled<T> &motion, const timeline<T> &times)
{
    T *starts = const_cast<T *>(motion.starts()), *spans = const_cast<T *>(motion.spans());
    auto *first = const_cast<std::uint32_t *>(motion.first());
    for (std::size_t j = times.degree - 1; j + 1 < times.control_count; ++j)
        if (!times.is_empty(j)) {
            *starts++ = times.knot(j);
            write_span(times, j, spans);
            spans += span_size(times.degree);
            *first++ = static_cast<std::uint32_t>(j + 1 - times.degree);
        }
    *starts = times.end();
}

// The span in which each cell begins, or a little before it: rounding may put a parameter into the cell after its own,
// by much less than a cell.
template <class T> void write_cells(const compiled<T> &motion)
{
    auto *cells = const_cast<std::uint32_t *>(motion.cells());
    const T *starts = motion.starts();
    std::uint32_t span = 0;
    for (std::size_t c = 0; c <= motion->cell_count; ++c) {
        const double part = (double(c) - 1.0 / 64) / double(motion->cell_count);
        const double at = motion->begin + part * (motion->end - motion->begin);
        while (span + 1 < motion->span_count && double(starts[span + 1]) <= at)
            ++span;
        cells[c] = span;
    }
    cells[motion->cell_count] = static_cast<std::uint32_t>(motion->span_count - 1);
}

// Bézier points of the generators from key to key, which stand in every third row: Hermite's, with the slopes of the
// parabola through each three neighbours, and at the ends of an open motion of the one that ends there.
template <class T> class key_curve {
    const timeline<T> &times;
    T *rows;
    std::size_t spans;
    bool closed;

    static bivector read(const T *row)
    {
        return {double(row[1]), double(row[2]), double(row[3]), double(row[4]), double(row[5]), double(row[6])};
    }
    double length(std::size_t span) const { return double(times.knot(3 * span + 3)) - double(times.knot(3 * span)); }
    bivector chord(std::size_t span) const
    {
        return (read(rows + 24 * (span + 1)) - read(rows + 24 * span)) * (1 / length(span));
    }
    // At the key between two spans.
    bivector slope_between(std::size_t before, std::size_t after) const
    {
        const double a = length(before), b = length(after);
        return (chord(before) * b + chord(after) * a) * (1 / (a + b));
    }
    bivector slope(std::size_t key) const
    {
        if (key > 0 && key < spans)
            return slope_between(key - 1, key);
        if (closed)
            return slope_between(spans - 1, 0);
        if (spans == 1)
            return chord(0);
        return key == 0 ? chord(0) * 2.0 - slope(1) : chord(spans - 1) * 2.0 - slope(spans - 1);
    }

public:
    key_curve(const timeline<T> &along, T *to, bool is_closed)
        : times(along), rows(to), spans((along.control_count - 1) / 3), closed(is_closed)
    {
    }
    void write() const
    {
        for (std::size_t j = 0; j < spans; ++j) {
            const double third = length(j) / 3;
            write_row(read(rows + 24 * j) + slope(j) * third, rows + 24 * j + 8);
            write_row(read(rows + 24 * (j + 1)) - slope(j + 1) * third, rows + 24 * j + 16);
        }
    }
};

// Of one motion: what its kind takes of its controls (compiled.h).
template <class T>
void write_controls(const motion_of<T> &motion, const timeline<T> &times, unsigned flags, std::size_t number, T *rows,
                    T *bases)
{
    control_reader<T> controls(motion, times, number, flags);
    const bool keys = motion.kind == MW_MOTION_GENERATOR_KEYS;
    const motor identity{1, 0, 0, 0, 0, 0, 0, 0};
    const motor from_base =
        has_generators(motion.kind) && motion.base ? reverse(normalized(load_motor<double>(*motion.base))) : identity;
    const std::size_t count = keys ? (times.control_count - 1) / 3 + 1 : times.control_count, step = keys ? 24 : 8;
    motor before = identity;
    for (std::size_t k = 0; k < count; ++k) {
        T *const row = rows + step * k;
        const motor control = controls.next(k);
        if (motion.kind == MW_MOTION_ADDITIVE)
            write_row(control, row);
        else if (motion.kind == MW_MOTION_MULTIPLICATIVE)
            write_row(unit_of<T>(control), row);
        else if (motion.kind == MW_MOTION_CUMULATIVE) {
            const motor here = normalized(control);
            write_row(k > 0 ? log(here * reverse(before)) : bivector{}, row);
            write_row(unit_of<T>(control), bases + 8 * k);
            before = here;
        } else if (k >= motion.control_count) // closed: the generators that it began with
            std::copy_n(row - step * motion.control_count, 8, row);
        else
            write_row(log(from_base * normalized(control)), row);
    }
    if (keys)
        key_curve<T>(times, rows, motion.closed != 0).write();
}

template <class T> void write_motion(const motion_of<T> &motion, unsigned flags, const compiled<T> &to)
{
    const timeline<T> times(motion);
    write_spans(to, times);
    write_cells(to);
    T *rows = const_cast<T *>(to.rows()), *bases = const_cast<T *>(to.bases());
    if (has_generators(motion.kind))
        write_row(motion.base ? unit_of<T>(load_motor<double>(*motion.base)) : motor{1, 0, 0, 0, 0, 0, 0, 0}, bases);
    for (std::size_t m = 0; m < to->motion_count; ++m, rows += 8 * times.control_count, bases += 8 * times.control_count)
        write_controls(motion, times, flags, m, rows, bases);
}

// ------------------------------------------------------------------------------------------------------- the API

// The header of what a description is compiled into, which says how large that is.
template <class T> mw_status make_header(compiled_header *header, const motion_of<T> *motion, std::size_t *where)
{
    if (!motion)
        return MW_ERROR_NULL;
    const mw_status status = check_description<T>(*motion, where);
    if (status != MW_OK)
        return status;
    const double numbers = double(number_of_motions(motion->motion_count)) * 16 * 3 * double(motion->control_count + 32);
    if (numbers * sizeof(T) > double(PTRDIFF_MAX / 4) || motion->control_count > UINT32_MAX / 4)
        return MW_ERROR_SIZE;
    *header = header_of<T>(*motion);
    return MW_OK;
}

template <class T> mw_status motion_size(std::size_t *size, const motion_of<T> *motion, std::size_t *where)
{
    std::size_t ignored;
    compiled_header header;
    const mw_status status = size ? make_header<T>(&header, motion, where ? where : &ignored) : MW_ERROR_NULL;
    if (status == MW_OK)
        *size = compiled<T>(header).size();
    return status;
}

template <class T, class Compiled>
mw_status compile_motion(const Compiled **result, void *memory, std::size_t size, const motion_of<T> *motion,
                         unsigned flags, std::size_t *where)
{
    std::size_t ignored;
    compiled_header header;
    where = where ? where : &ignored;
    *where = 0;
    if (!result || !memory)
        return MW_ERROR_NULL;
    mw_status status = make_header<T>(&header, motion, where);
    if (status != MW_OK)
        return status;
    if (flags & ~(motion->kind == MW_MOTION_MULTIPLICATIVE ? 0u : unsigned(MW_KEEP_SIGNS)))
        return MW_ERROR_FLAGS;
    const std::size_t needed = compiled<T>(header).size();
    if (size < needed || address(static_cast<char *>(memory)) % alignof(compiled_header))
        return MW_ERROR_MEMORY;
    const byte_range to = range_of(static_cast<const char *>(memory), needed);
    const std::size_t motions = number_of_motions(motion->motion_count);
    if (to.meets(range_of(motion->controls, motions * motion->control_count)) ||
        (motion->knots && to.meets(range_of(motion->knots, motion->knot_count))) ||
        (motion->weights && to.meets(range_of(motion->weights, motion->control_count))) ||
        (motion->base && to.meets(range_of(motion->base, 1))))
        return MW_ERROR_OVERLAP;
    status = check_controls<T>(*motion, flags, where);
    if (status != MW_OK)
        return status;
    std::memset(memory, 0, needed); // the gaps too: what was there before is nobody's business who copies or stores them
    auto *const written = static_cast<compiled_header *>(memory);
    *written = header;
    write_motion<T>(*motion, flags, compiled<T>(*written));
    *result = static_cast<const Compiled *>(memory);
    return MW_OK;
}

template <class T> mw_status motion_domain(T *domain, const typename c_types<T>::compiled *motion)
{
    const mw_status status = domain ? check_compiled<T>(motion) : MW_ERROR_NULL;
    if (status == MW_OK) {
        domain[0] = compiled_of<T>(motion).begin();
        domain[1] = compiled_of<T>(motion).end();
    }
    return status;
}

} // namespace
} // namespace motorway

using namespace motorway;
#include "../../generated/calls/motion_compile.inc"
