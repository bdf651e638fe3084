/* tinygltf is a header whose code is compiled here, once: without images, which a moving mesh has none of. */
#include <nlohmann/json.hpp>
#define TINYGLTF_IMPLEMENTATION
#include <tiny_gltf.h>
