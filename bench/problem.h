// The data of one benchmark: the arrays of a kernel in one layout at one count, for the library and its rivals alike.
#pragma once

#include <cstddef>
#include <cstdint>
#include <cstdlib>
#include <memory>
#include <optional>
#include <string>
#include <type_traits>
#include <vector>

namespace motorway::bench {

// Of elements of T under motors of M.
template <class T, class M = T>
constexpr const char *precision_name = !std::is_same_v<T, M> ? "mixed" : sizeof(T) == sizeof(float) ? "f32" : "f64";

// How the components of an element and the elements of an array lie.
enum class layout {
    packed,  // components adjacent, and elements too
    strided, // components adjacent, elements apart
    soa,     // one array a component
    columns  // packed, and of a grid the images of an element side by side: in the others those of a motor are
};
constexpr layout layouts[] = {layout::packed, layout::strided, layout::soa, layout::columns};

// An array of elements of several components, in memory of its own.
template <class T> class array {
public:
    // `stride` is the scalars from an element to the next, of which soa takes no notice. Arrays of different `place`
    // start at different cache lines of a page: else the many arrays of a kernel in soa, at a count that is a power
    // of two, would meet in the same sets of the cache.
    array(std::size_t components, std::size_t stride, layout kind, std::size_t count, std::size_t place);

    // Of each four components, which lie in memory as w x y z, the last becomes the first: then x y z w.
    void rotate_fours();

    std::size_t components() const { return component_.size(); }
    std::size_t stride() const { return stride_; } // bytes
    T *const *component() const { return component_.data(); }
    T &at(std::size_t component, std::size_t element) const
    {
        return component_[component][element * (stride_ / sizeof(T))];
    }
    std::size_t span() const { return span_; } // bytes from the first element to the last

private:
    struct release {
        void operator()(T *memory) const { std::free(memory); }
    };
    std::unique_ptr<T[], release> memory_;
    std::vector<T *> component_;
    std::size_t stride_, span_;
};

enum class operand {
    point,
    direction,
    tangent,
    vertex,
    vector,
    line,
    motor,     // S̄S = 1
    any_motor, // a multiple of such, with a pseudoscalar that is not zero: as sums of motors are
    bivector,
    weights,
    parameter, // of an interpolation, and the exponent of a power
    sorted_parameter, // of one motion
    control,   // of a motion: normalised, within 60° of one rotation, so that sums do not vanish; packed alone
    quaternion,
    translation,
    axis_angle,
    euler_angles,
    dual_quaternion,
    screw,
    // What lies in memory in one order alone, its components adjacent.
    quaternion_wxyz,
    dual_quaternion_wxyz,
    rows_3x4,
    rows_4x4,
    columns_3x4,
    columns_4x4
};
constexpr bool is_adjacent(operand operand) { return operand >= operand::quaternion_wxyz; }

// Terms of a blend.
constexpr std::size_t blend_terms = 4;

constexpr std::size_t components_of(operand operand)
{
    switch (operand) {
    case operand::point:
    case operand::direction:
    case operand::translation:
    case operand::euler_angles: return 3;
    case operand::tangent:
    case operand::quaternion:
    case operand::quaternion_wxyz:
    case operand::axis_angle: return 4;
    case operand::vertex: return 6; // a position and a normal
    case operand::vector: return 5;
    case operand::line:
    case operand::bivector: return 6;
    case operand::motor:
    case operand::any_motor:
    case operand::control:
    case operand::dual_quaternion:
    case operand::dual_quaternion_wxyz:
    case operand::screw: return 8;
    case operand::rows_3x4:
    case operand::columns_3x4: return 12;
    case operand::rows_4x4:
    case operand::columns_4x4: return 16;
    case operand::weights: return blend_terms;
    case operand::parameter:
    case operand::sorted_parameter: return 1;
    }
    return 0;
}

// What a kernel takes and makes, in the order of its C function.
struct arguments {
    std::vector<operand> out, in;
    std::size_t fixed = 0;       // motors that all elements share: one, two, a palette, those of a grid
    bool motor_an_element = false;
    bool index_an_element = false;
    std::size_t images = 1;      // results an element
    std::size_t joints = 1;      // elements an instance: the count is that of instances
    std::size_t controls = 0;    // of a motion, where elements are sampled from one
    bool motion_an_element = false;
    std::size_t natural_count = 0; // of a crowd, of a mesh: no other is measured, unless it is 0
};
bool allows(const arguments &arguments, layout kind);

// The poses of a grid, and the motors of a palette: the bones of a character, the parts of a machine.
constexpr std::size_t shared_motors = 64;

// Of a skeleton: each is the child of the one before. Instances lie side by side in soa, joint after joint, and else
// one after the other.
constexpr std::size_t skeleton_joints = 64, skeletons = 1000; // a crowd

// Motions are of degree three and over [0, 1], their knots equally far apart and clamped.
constexpr std::size_t motion_degree = 3, spline_controls = 16, bezier_controls = motion_degree + 1;

// Of the many motions of an `each` kernel, if they are sampled at the same one.
constexpr double shared_parameter = 0.4;

// Of one motion that is compiled.
constexpr std::size_t compiled_controls = 1000;

// A motion on a mesh.
constexpr std::size_t mesh_frames = 1000, mesh_vertices = 1839; // those of the bunny in examples/data

// Elements of one rigid part lie together in a mesh, so their indices come in runs.
constexpr std::size_t index_run = 32;

// Of the mixed functions: taken off before a motor moves a point, and added after.
struct shift {
    double before[3] = {0.25, -0.5, 0.75}, after[3] = {-0.5, 0.25, 1};
};

// T is what elements are made of, M what motors that move them are.
template <class T, class M = T> struct problem {
    std::string kernel; // "apply_point_one"
    layout kind;
    std::size_t count, elements, images;
    std::optional<array<M>> motors; // of the elements, if each has its own
    std::vector<array<T>> in;
    std::vector<M> fixed;                // motors, packed
    std::vector<M> controls;             // of all motions, packed, motion after motion
    std::vector<std::uint16_t> indices;  // of the elements, into the fixed motors
    std::vector<std::int32_t> parents;   // of the joints of a skeleton
    std::vector<array<T>> out;           // of a grid, motor by motor or (columns) element by element

    problem(std::string name, const arguments &arguments, layout where, std::size_t how_many);

    std::size_t results() const { return elements * images; }
    // Of motors and motions that elements share it is left out what they take, and of others the controls that a
    // sample does not depend on.
    std::size_t bytes_read() const;
    std::size_t bytes_written() const;
    std::size_t span_read() const;
    std::size_t span_written() const;

private:
    std::size_t index_size() const { return indices.size() * sizeof(indices[0]); }

    std::size_t control_size_; // bytes read of all motions
};

// "aos", "aos32" with a stride of 32 bytes, "soa" or "aos-columns".
template <class T> std::string layout_name(const arguments &arguments, layout kind);

// The bytes of the arrays of a problem, with what strides leave between.
template <class T, class M> std::size_t problem_size(const arguments &arguments, layout kind, std::size_t count);

} // namespace motorway::bench
