#include "convert_api.h"
#include "motions.h"
#include "random.h"
#include "room.h"

namespace motorway::memcheck {
namespace {

using testing::api;

template <class T>
std::vector<T> numbers(std::size_t count)
{
    testing::Random random(3);
    std::vector<T> numbers;
    for (std::size_t k = 0; k < count; ++k)
        numbers.push_back(static_cast<T>(random.uniform(0.5, 1.5)));
    return numbers;
}

template <class T>
void check_makers()
{
    using A = api<T>;
    using C = api<T>;
    const std::vector<T> three = numbers<T>(3), six = numbers<T>(6);
    const T axis[] = {0, T(0.6), T(0.8)};
    Room<typename A::motor> motor(1);
    Room<typename C::twist> twist(1);
    Room<T> position(3);
    must(A::translation(motor.get(), three.data()), "translation");
    motor.touch();
    must(A::rotation(motor.get(), axis, 1, three.data()), "rotation");
    must(A::rotation(motor.get(), axis, 1, nullptr), "rotation about the origin");
    motor.touch();
    must(C::split_bivector(twist.get(), six.data()), "split_bivector");
    twist.touch();
    must(C::twist_pose(motor.get(), twist.get(), T(0.5)), "twist_pose");
    must(C::twist_position(position.get(), twist.get(), T(0.5)), "twist_position");
    motor.touch();
    position.touch();
    must(A::twist_velocity(position.get(), six.data(), three.data()), "twist_velocity");
    position.touch();
}

// In strides with uninitialised bytes between.
template <class T>
void check_checks()
{
    constexpr std::size_t count = 5, gap = 3;
    Room<T> motors(count * (8 + gap) - gap), matrices(count * (16 + gap) - gap);
    for (std::size_t i = 0; i < count; ++i)
        for (std::size_t k = 0; k < 8; ++k)
            motors.get()[i * (8 + gap) + k] = k == 0;
    for (std::size_t i = 0; i < count; ++i)
        for (std::size_t k = 0; k < 16; ++k)
            matrices.get()[i * (16 + gap) + k] = k % 5 == 0;
    std::size_t first_bad = 0;
    T deviation;
    must(api<T>::check_motors(
             api<T>::const_motors_aos(reinterpret_cast<typename api<T>::motor *>(motors.get()), sizeof(T[8 + gap])),
             count, &first_bad),
         "check_motors");
    must(api<T>::check_matrices({matrices.get(), sizeof(T[16 + gap]), MW_MATRIX_ROWS_4X4}, count, T(0.01),
                                       &first_bad, &deviation),
         "check_matrices");
    touch(deviation);
}

void check_the_rest()
{
    Room<unsigned char> indices(3 * 4 - 3);
    for (std::size_t i = 0; i < 3; ++i)
        indices.get()[4 * i] = static_cast<unsigned char>(i);
    must(testing::check_indices(mw_indices_u8(indices.get(), 4), 3, 3, nullptr), "check_indices");
    touch(mw_version());
    touch(*mw_status_text(MW_ERROR_ISA));
    touch(*mw_isas());
}

}  // namespace

void check_single_motors()
{
    check_makers<float>();
    check_makers<double>();
    check_checks<float>();
    check_checks<double>();
    check_the_rest();
}

}  // namespace motorway::memcheck
