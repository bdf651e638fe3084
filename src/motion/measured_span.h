// How far a point of the body goes between two knots: the integral of its speed, and its inverse.
//
// The speed is that of the twist in the frame of the body, where the point stays where it is. Between two knots it is
// smooth, but for kinks where it touches zero: there pieces are halved until what is uncertain no longer counts.
#pragma once

#include "../scalar_math.h"
#include "sample.h"

namespace motorway {

// ------------------------------------------------------------------------------------------------------- speeds

struct vector3 {
    double x, y, z;
};

inline double length_of(const vector3 &v, double w = 0)
{
    return square_root(v.x * v.x + v.y * v.y + v.z * v.z + w * w);
}

// 2 (b1i, b2i, b3i) + ω × place with ω = 2 (b23, -b13, b12).
template <class T> vector3 velocity_of(const T *twist, const vector3 &place)
{
    const double b12 = twist[0], b13 = twist[1], b23 = twist[2];
    return {2 * (twist[3] - b13 * place.z - b12 * place.y), 2 * (twist[4] + b12 * place.x - b23 * place.z),
            2 * (twist[5] + b23 * place.y + b13 * place.x)};
}

// Samples that are made at once.
constexpr std::size_t block = 32;

// A point of the body under one motion.
template <class T> class moving_point {
    const compiled<T> motion;
    const std::size_t index;
    const vector3 place;

public:
    moving_point(const compiled<T> &of, std::size_t number, const T *point)
        : motion(of), index(number), place{point[0], point[1], point[2]}
    {
    }

    // At up to `block` parameters of the domain. *reach grows to the largest of the coordinates that the speeds come
    // from: their rounding errors are epsilons of it.
    void speeds(const T *parameters, std::size_t count, double *speed, double *reach) const
    {
        T poses[8][block], twists[6][block];
        motion_samples<T>(motion, motions_sampled::one, index, {parameters, sizeof(T)}, count, MW_BODY_FRAME)
            .sample_twist(rows_of(poses), rows_of(twists));
        for (std::size_t i = 0; i < count; ++i) {
            const T twist[6] = {twists[0][i], twists[1][i], twists[2][i], twists[3][i], twists[4][i], twists[5][i]};
            speed[i] = length_of(velocity_of(twist, place));
            *reach = std::max(*reach, reach_of(poses, i));
        }
    }

private:
    template <int N> static view<T, N> rows_of(T (&rows)[N][block])
    {
        view<T, N> result{{}, sizeof(T)};
        for (int c = 0; c < N; ++c)
            result.component[c] = rows[c];
        return result;
    }

    double reach_of(const T (&poses)[8][block], std::size_t i) const
    {
        const double turned = length_of({poses[1][i], poses[2][i], poses[3][i]}, poses[0][i]);
        const double moved = length_of({poses[4][i], poses[5][i], poses[6][i]}, poses[7][i]);
        return length_of(place) + 2 * moved / turned;
    }
};

// ------------------------------------------------------------------------------------------------- integration

// The rule of Gauss and Legendre with eight points, on [-1, 1].
constexpr std::size_t rule_size = 8;
constexpr double rule_nodes[rule_size] = {-0.96028985649753623168, -0.79666647741362673959, -0.52553240991632898582,
                                          -0.18343464249564980494, 0.18343464249564980494,  0.52553240991632898582,
                                          0.79666647741362673959,  0.96028985649753623168};
constexpr double rule_weights[rule_size] = {0.10122853629037625915, 0.22238103445337447054, 0.31370664587788728734,
                                            0.36268378337836198297, 0.36268378337836198297, 0.31370664587788728734,
                                            0.22238103445337447054, 0.10122853629037625915};

// Part of a span.
struct stretch {
    double begin, end;
};
constexpr std::size_t stretches_at_once = block / rule_size;

// The integral over [-1, 1] of the polynomial that has `values` beside the nodes of the rule, as far off as `beside`
// says: where the numbers of T are. The slopes at the nodes, which correct for that, are those of the polynomial
// through the values, by its barycentric form.
inline double integral(const double *values, const double *beside)
{
    double factors[rule_size], sum = 0;
    for (std::size_t i = 0; i < rule_size; ++i) {
        const double factor = square_root((1 - rule_nodes[i] * rule_nodes[i]) * rule_weights[i]);
        factors[i] = i % 2 ? -factor : factor;
    }
    for (std::size_t i = 0; i < rule_size; ++i) {
        double slope = 0;
        for (std::size_t j = 0; j < rule_size; ++j)
            if (j != i)
                slope += factors[j] * (values[j] - values[i]) / (rule_nodes[i] - rule_nodes[j]);
        sum += rule_weights[i] * (values[i] - beside[i] * slope / factors[i]);
    }
    return sum;
}

// A part of a span with the lengths of its halves, and how far their sum is from its own.
struct piece {
    double begin, end, left, right, doubt, before; // before: the length of the span up to it

    double middle() const { return begin + (end - begin) / 2; }
    double length() const { return left + right; }
};

// A part of a span, and the lengths before and of it.
struct measured_stretch : stretch {
    double before, length;
};

// The way of a point between two knots, cut where the speed is not smooth.
template <class T> class measured_span {
    // A kink takes one for each bit of precision. Roundings, which do not become smaller, may use up all.
    static constexpr std::size_t most_pieces = 128;
    static constexpr double epsilon = std::numeric_limits<T>::epsilon();

    const moving_point<T> &point;
    const T first, before_last;
    const double resolution; // the distance of numbers of T in the span
    double reach = 0, total = 0;
    piece pieces[most_pieces];
    std::size_t count = 1;

public:
    measured_span(const moving_point<T> &of, T begin, T end)
        : point(of), first(begin), before_last(next_below(end)),
          resolution(epsilon * std::max(std::fabs(double(begin)), std::fabs(double(end))))
    {
        piece &whole = pieces[0];
        whole.begin = begin, whole.end = end;
        const stretch parts[] = {
            {whole.begin, whole.end}, {whole.begin, whole.middle()}, {whole.middle(), whole.end}};
        double lengths[3];
        measure(parts, 3, lengths);
        set_halves(whole, lengths[1], lengths[2], lengths[0]);
        while (count < most_pieces && doubt() > uncertainty())
            halve(least_certain());
        for (std::size_t k = 0; k < count; ++k) {
            pieces[k].before = total;
            total += pieces[k].length();
        }
    }
    measured_span(const measured_span &) = delete;

    double length() const { return total; }

    // What the length may be off by: a rounding error of the length, and of the places at both ends.
    double uncertainty() const
    {
        double sum = 0;
        for (std::size_t k = 0; k < count; ++k)
            sum += pieces[k].length();
        return 4 * epsilon * (sum + reach);
    }

    // The lengths from the first knot to up to stretches_at_once parameters.
    void lengths_until(const T *parameters, std::size_t number, double *lengths)
    {
        stretch rest[stretches_at_once] = {};
        measured_stretch half[stretches_at_once];
        for (std::size_t k = 0; k < number; ++k) {
            half[k] = half_at(parameters[k]);
            rest[k] = {half[k].begin, static_cast<double>(parameters[k])};
        }
        measure(rest, number, lengths);
        for (std::size_t k = 0; k < number; ++k)
            lengths[k] = half[k].before + std::clamp(lengths[k], 0.0, half[k].length);
    }

    // Where the length from the first knot is `goal`, to within the tolerance: between two bounds that close in, by
    // Newton's method, and by halves where that has not come to an end.
    double parameter_at(double goal, double tolerance)
    {
        const measured_stretch half = half_at_length(goal);
        const double rest = goal - half.before;
        if (!(rest > 0) || !(rest < half.length))
            return rest > 0 ? half.end : half.begin;
        double low = half.begin, high = half.end, t = low + (high - low) * (rest / half.length);
        for (int step = 0; high - low > resolution; ++step) {
            const stretch until = {half.begin, t};
            double length;
            measure(&until, 1, &length);
            const double miss = length - rest;
            if (std::fabs(miss) <= tolerance)
                break;
            (miss < 0 ? low : high) = t;
            const double newton = t - miss / speed_at(t);
            t = step < 8 && low < newton && newton < high ? newton : low + (high - low) / 2;
        }
        return t;
    }

private:
    // The number of T nearest to t that belongs to the span.
    T in_span(double t) const { return std::clamp(static_cast<T>(t), first, before_last); }

    double speed_at(double t)
    {
        const T parameter = in_span(t);
        double speed;
        point.speeds(&parameter, 1, &speed, &reach);
        return speed;
    }

    void measure(const stretch *stretches, std::size_t number, double *lengths)
    {
        T parameters[block] = {};
        double beside[block], speeds[block];
        for (std::size_t k = 0, i = 0; k < number; ++k) {
            const double begin = stretches[k].begin, half = (stretches[k].end - begin) / 2;
            for (std::size_t j = 0; j < rule_size; ++j, ++i) {
                const double node = half + half * rule_nodes[j]; // from the beginning
                parameters[i] = in_span(begin + node);
                // Too short a stretch has no slope.
                beside[i] = half > 16 * resolution ? (static_cast<double>(parameters[i]) - begin - node) / half : 0;
            }
        }
        point.speeds(parameters, number * rule_size, speeds, &reach);
        for (std::size_t k = 0; k < number; ++k)
            lengths[k] = (stretches[k].end - stretches[k].begin) / 2 *
                         integral(speeds + k * rule_size, beside + k * rule_size);
    }

    void set_halves(piece &of, double left, double right, double whole) const
    {
        of.left = left, of.right = right;
        of.doubt = of.end - of.begin > 64 * resolution ? std::fabs(whole - (left + right)) : 0;
    }

    double doubt() const
    {
        double sum = 0;
        for (std::size_t k = 0; k < count; ++k)
            sum += pieces[k].doubt;
        return sum;
    }
    std::size_t least_certain() const
    {
        std::size_t worst = 0;
        for (std::size_t k = 1; k < count; ++k)
            if (pieces[k].doubt > pieces[worst].doubt)
                worst = k;
        return worst;
    }

    void halve(std::size_t k)
    {
        std::move_backward(pieces + k + 1, pieces + count, pieces + count + 1);
        ++count;
        piece &left = pieces[k], &right = pieces[k + 1];
        right = left;
        left.end = right.begin = left.middle();
        const stretch quarters[] = {{left.begin, left.middle()},
                                    {left.middle(), left.end},
                                    {right.begin, right.middle()},
                                    {right.middle(), right.end}};
        double lengths[4];
        measure(quarters, 4, lengths);
        set_halves(left, lengths[0], lengths[1], left.left);
        set_halves(right, lengths[2], lengths[3], right.right);
    }

    // Halves are where a single rule is enough.
    static measured_stretch left_of(const piece &of) { return {{of.begin, of.middle()}, of.before, of.left}; }
    static measured_stretch right_of(const piece &of)
    {
        return {{of.middle(), of.end}, of.before + of.left, of.right};
    }
    measured_stretch half_at(double t) const
    {
        std::size_t k = count - 1;
        while (k > 0 && t < pieces[k].begin)
            --k;
        return t < pieces[k].middle() ? left_of(pieces[k]) : right_of(pieces[k]);
    }
    measured_stretch half_at_length(double length) const
    {
        std::size_t k = count - 1;
        while (k > 0 && length < pieces[k].before)
            --k;
        const measured_stretch right = right_of(pieces[k]);
        return length < right.before ? left_of(pieces[k]) : right;
    }
};

} // namespace motorway
