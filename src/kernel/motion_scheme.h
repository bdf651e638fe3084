// The four ways to make a pose of the controls of a span.
#pragma once

#include "motion_span.h"
#include "motion_twist.h"

namespace motorway {
namespace MOTORWAY_ISA_NAME {
namespace {

// `pose` makes a pose of a span's controls at its local parameter u; `moving` also the twist, in the frame of the space.

struct additive_scheme { // its poses have a loop of their own
    template <class T, class V>
    static void moving(std::size_t degree, const place<T> &where, const jet<V> &u, V *out, V *twist)
    {
        jet<V> sum[motor_size];
        blend_rows(degree, where, u, sum);
        for (int n = 0; n < motor_size; ++n)
            out[n] = sum[n].value;
        twist_of<ratio_motor_each>(sum, twist);
    }
};

struct multiplicative_scheme {
    template <class T, class V> static void pose(std::size_t degree, const place<T> &where, const jet<V> &u, V *out)
    {
        interpolate(degree, where, u.value, out);
    }
    template <class T, class V>
    static void moving(std::size_t degree, const place<T> &where, const jet<V> &u, V *out, V *twist)
    {
        jet<V> both[motor_size];
        interpolate(degree, where, u, both);
        for (int n = 0; n < motor_size; ++n)
            out[n] = both[n].value;
        twist_of<ratio_motor_each_unit>(both, twist);
    }

private:
    // The tableau of de Casteljau, or de Boor, from the controls on: level r leaves r of them.
    template <class T, class N>
    static void interpolate(std::size_t degree, const place<T> &where, const N &u, N *out)
    {
        N tableau[max_degree + 1][motor_size];
        for (std::size_t k = 0; k <= degree; ++k) {
            vector<T> row[motor_size];
            where.load_row(k, row);
            for (int n = 0; n < motor_size; ++n)
                tableau[k][n] = N(row[n]);
        }
        for (std::size_t r = degree; r > 0; --r)
            for (std::size_t k = 0; k < r; ++k) {
                N in[2 * motor_size + 1];
                copy(motor_size, tableau[k], in);
                copy(motor_size, tableau[k + 1], in + motor_size);
                in[2 * motor_size] = ratio_of(where, u, r, k);
                slerp_motor_each::body<N>(in, tableau[k]);
            }
        copy(motor_size, tableau[0], out);
    }
};

struct cumulative_scheme {
    template <class T, class V> static void pose(std::size_t degree, const place<T> &where, const jet<V> &u, V *out)
    {
        V weight[max_degree + 1];
        make_weights(degree, where, u.value, weight);
        multiply(degree, where, weight, out, [](const V &, const V *, const V *) {});
    }
    template <class T, class V>
    static void moving(std::size_t degree, const place<T> &where, const jet<V> &u, V *out, V *twist)
    {
        jet<V> weight[max_degree + 1];
        make_weights(degree, where, u, weight);
        for (int n = 0; n < bivector_size; ++n)
            twist[n] = V(T(0));
        // Each factor adds its own velocity, as those that act after it move it.
        multiply(degree, where, weight, out, [&](const jet<V> &power, const V *generator, const V *after) {
            V own[bivector_size], moved[bivector_size];
            for (int n = 0; n < bivector_size; ++n)
                own[n] = power.derivative * generator[n];
            move_bivector<apply_bivector_each_unit>(after, own, moved);
            for (int n = 0; n < bivector_size; ++n)
                twist[n] = twist[n] + moved[n];
        });
    }

private:
    // The product from its last factor, the base, to the first. Each generator has the power w_k + ... + w_d.
    template <class T, class N, class V, class Visit>
    static void multiply(std::size_t degree, const place<T> &where, N *weight, V *out, const Visit &visit)
    {
        for (std::size_t k = degree; k-- > 1;)
            weight[k] = weight[k] + weight[k + 1];
        where.load_base(out);
        for (std::size_t k = 1; k <= degree; ++k) {
            V row[motor_size], scaled[bivector_size], factor[motor_size];
            where.load_row(k, row);
            visit(weight[k], row + 1, out);
            for (int n = 0; n < bivector_size; ++n)
                scaled[n] = value_of(weight[k]) * row[1 + n];
            exp_motor_each::body<V>(scaled, factor);
            compose(factor, out, out);
        }
    }
};

struct generator_scheme {
    template <class T, class V> static void pose(std::size_t degree, const place<T> &where, const jet<V> &u, V *out)
    {
        V sum[motor_size], power[motor_size];
        blend_rows(degree, where, u.value, sum);
        exp_motor_each::body<V>(sum + 1, power);
        multiply(where, power, out);
    }
    template <class T, class V>
    static void moving(std::size_t degree, const place<T> &where, const jet<V> &u, V *out, V *twist)
    {
        jet<V> sum[motor_size];
        V generator[bivector_size], power[motor_size];
        blend_rows(degree, where, u, sum);
        for (int n = 0; n < bivector_size; ++n)
            generator[n] = sum[1 + n].value;
        exp_motor_each::body<V>(generator, power);
        twist_of_exponential(sum + 1, power, twist);
        multiply(where, power, out);
    }

private:
    template <class T, class V> static void multiply(const place<T> &where, const V *power, V *out)
    {
        V base[motor_size];
        where.load_base(base);
        compose(base, power, out);
    }
};

} // namespace
} // namespace MOTORWAY_ISA_NAME
} // namespace motorway
