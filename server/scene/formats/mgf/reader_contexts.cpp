// Statements about colours, materials and vertices.
#include "server/scene/formats/mgf/numbers.h"
#include "server/scene/formats/mgf/reader.h"

namespace raywalk {
namespace {

glm::dvec3 three(MgfReader::Words words) {
  return {mgf_number(words[0]), mgf_number(words[1]), mgf_number(words[2])};
}

}  // namespace

void MgfReader::color(Words arguments) {
  colors_.select(arguments);
}

void MgfReader::color_xy(Words arguments) {
  colors_.current() = chromaticity(mgf_number(arguments[0]), mgf_number(arguments[1]));
}

void MgfReader::color_spectrum(Words arguments) {
  std::vector<double> values;
  for (const std::string_view word : arguments.subspan(2)) values.push_back(mgf_number(word));
  colors_.current() = spectrum(mgf_number(arguments[0]), mgf_number(arguments[1]), values);
}

void MgfReader::color_temperature(Words arguments) {
  colors_.current() = temperature(mgf_number(arguments[0]));
}

void MgfReader::color_mixture(Words arguments) {
  if (arguments.size() % 2 != 0) throw std::runtime_error("'cmix' takes pairs of a weight and a colour");
  std::vector<ColorShare> shares;
  for (size_t i = 0; i < arguments.size(); i += 2) {
    shares.push_back({mgf_number(arguments[i]), colors_.named(arguments[i + 1])});
  }
  colors_.current() = mixture(shares);
}

void MgfReader::material(Words arguments) {
  materials_.select(arguments);
}

/// An amount in the current colour, and a roughness if there is a second argument. The material is to change.
MgfMaterial::Term MgfReader::term(Words arguments) {
  materials_.current().index = MgfMaterial::kNotAdded;
  const double amount = mgf_number(arguments[0]);
  if (amount < 0.0) throw std::runtime_error("a negative share of the light");
  if (amount > kMaxFloat) throw std::runtime_error("more light than a float can tell");
  return {amount, colors_.current(), arguments.size() > 1 ? mgf_number(arguments[1]) : 0.0};
}

void MgfReader::sides(Words arguments) {
  const u64 count = mgf_count(arguments[0], 1);
  if (count > 2) throw std::runtime_error("a surface has 1 or 2 sides");
  materials_.current().two_sided = count == 2;
  materials_.current().index = MgfMaterial::kNotAdded;
}

void MgfReader::diffuse(Words arguments) {
  materials_.current().diffuse = term(arguments);
}

void MgfReader::translucent(Words arguments) {
  materials_.current().translucent = term(arguments);
}

void MgfReader::emitted(Words arguments) {
  materials_.current().emitted = term(arguments);
}

void MgfReader::specular(Words arguments) {
  materials_.current().specular = term(arguments);
}

void MgfReader::transparent(Words arguments) {
  materials_.current().transparent = term(arguments);
}

void MgfReader::refraction(Words arguments) {
  const double ior = mgf_number(arguments[0]);
  mgf_number(arguments[1]);  // the imaginary part tells of metals, which let nothing pass
  materials_.current().ior = ior;
  materials_.current().index = MgfMaterial::kNotAdded;
}

void MgfReader::vertex(Words arguments) {
  vertices_.select(arguments);
}

void MgfReader::point(Words arguments) {
  vertices_.current().position = three(arguments);
}

void MgfReader::normal(Words arguments) {
  vertices_.current().normal = three(arguments);
}

}  // namespace raywalk
