// The code of tinygltf, which is a library of one header, with the system's JSON parser.
#include <fstream>
#include <nlohmann/json.hpp>

#define TINYGLTF_IMPLEMENTATION
#include "server/scene/formats/gltf/tinygltf.h"
