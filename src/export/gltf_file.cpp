// SPDX-License-Identifier: MIT
#include "export/gltf_file.h"

#include <algorithm>
#include <cmath>
#include <cstring>
#include <map>
#include <sstream>
#include <tiny_gltf.h>

#include "base/color.h"
#include "base/error.h"
#include "frame/to_glm.h"

namespace polhode {
namespace {

using nlohmann::json;

tinygltf::Value value_of(const json& from) {
  if (from.is_object()) {
    tinygltf::Value::Object object;
    for (const auto& [key, one] : from.items())
      object[key] = value_of(one);
    return tinygltf::Value(object);
  }
  if (from.is_array()) {
    tinygltf::Value::Array array;
    for (const json& one : from)
      array.push_back(value_of(one));
    return tinygltf::Value(array);
  }
  if (from.is_string()) return tinygltf::Value(from.get<std::string>());
  if (from.is_boolean()) return tinygltf::Value(from.get<bool>());
  if (from.is_number_integer()) return tinygltf::Value(from.get<int>());
  return tinygltf::Value(from.get<double>());
}

// The file while it is put together.
class Writer {
 public:
  explicit Writer(const GltfDocument& document) : document_(document) {
    model_.buffers.emplace_back();
  }

  std::string bytes() {
    for (const GltfMaterial& material : document_.materials)
      add_material(material);
    for (const GltfMesh& mesh : document_.meshes)
      add_mesh(mesh);
    for (const GltfCamera& camera : document_.cameras)
      add_camera(camera);
    for (const GltfLight& light : document_.lights)
      add_light(light);
    tinygltf::Animation animation;
    animation.name = "motion";
    tinygltf::Scene scene;
    scene.name = document_.title;
    for (const GltfNode& node : document_.nodes)
      add_node(node, scene, animation);
    if (!animation.channels.empty()) model_.animations.push_back(animation);
    model_.scenes.push_back(scene);
    model_.defaultScene = 0;
    model_.asset.version = "2.0";
    model_.asset.generator = document_.generator;
    model_.asset.copyright = document_.copyright;
    model_.asset.extras = value_of(document_.extras);
    if (!model_.lights.empty()) model_.extensionsUsed.emplace_back("KHR_lights_punctual");
    if (unlit_) model_.extensionsUsed.emplace_back("KHR_materials_unlit");
    std::ostringstream stream;
    if (!tinygltf::TinyGLTF().WriteGltfSceneToStream(&model_, stream, false, true)) {
      throw environment_error("the glTF file cannot be put together");
    }
    return stream.str();
  }

 private:
  // returns the index of the buffer view
  int add_bytes(const void* data, std::size_t size, int target) {
    std::vector<unsigned char>& buffer = model_.buffers.front().data;
    buffer.resize((buffer.size() + 3) / 4 * 4);
    tinygltf::BufferView view;
    view.buffer = 0;
    view.byteOffset = buffer.size();
    view.byteLength = size;
    view.target = target;
    const auto* bytes = static_cast<const unsigned char*>(data);
    buffer.insert(buffer.end(), bytes, bytes + size);
    model_.bufferViews.push_back(view);
    return static_cast<int>(model_.bufferViews.size()) - 1;
  }

  int add_accessor(const std::vector<float>& values, int components, int type, int target) {
    tinygltf::Accessor accessor;
    accessor.bufferView = add_bytes(values.data(), values.size() * sizeof(float), target);
    accessor.componentType = TINYGLTF_COMPONENT_TYPE_FLOAT;
    accessor.count = values.size() / static_cast<std::size_t>(components);
    accessor.type = type;
    model_.accessors.push_back(accessor);
    return static_cast<int>(model_.accessors.size()) - 1;
  }

  // for positions and times, whose range readers want to know
  void add_range(int accessor, const std::vector<float>& values, std::size_t components) {
    tinygltf::Accessor& one = model_.accessors[static_cast<std::size_t>(accessor)];
    for (std::size_t i = 0; i < components; ++i) {
      float low = values[i], high = values[i];
      for (std::size_t k = i; k < values.size(); k += components) {
        low = std::min(low, values[k]);
        high = std::max(high, values[k]);
      }
      one.minValues.push_back(static_cast<double>(low));
      one.maxValues.push_back(static_cast<double>(high));
    }
  }

  void add_material(const GltfMaterial& from) {
    const Material& look = from.look;
    tinygltf::Material material;
    material.name = from.name;
    material.doubleSided = from.both_sides;
    const double alpha = static_cast<double>(look.alpha * look.fade);
    const bool marked = look.mark_width > 0.0f;
    auto& pbr = material.pbrMetallicRoughness;
    pbr.baseColorFactor = {linear_of_srgb(look.color.r),
                           linear_of_srgb(look.color.g),
                           linear_of_srgb(look.color.b),
                           alpha};
    if (marked) pbr.baseColorFactor = {1.0, 1.0, 1.0, alpha};
    pbr.metallicFactor = look.finish == Finish::metal ? 0.6 : 0.0;
    pbr.roughnessFactor = look.finish == Finish::metal ? 0.4
                          : look.finish == Finish::ceramic
                              ? 0.15
                              : 1.0 - 0.5 * static_cast<double>(look.gloss);
    if (alpha < 1.0 || look.soft) material.alphaMode = "BLEND";
    // a line whose colour is to be recognised shines by half
    if (look.vivid) {
      for (int i = 0; i < 3; ++i)
        material.emissiveFactor.push_back(0.35 * pbr.baseColorFactor[static_cast<std::size_t>(i)]);
    }
    if (look.flat) {
      material.extensions["KHR_materials_unlit"] = tinygltf::Value(tinygltf::Value::Object());
      unlit_ = true;
    }
    material.extras = value_of(film_look(look));
    model_.materials.push_back(material);
  }

  // what the standard model of glTF cannot say
  static json film_look(const Material& look) {
    const auto color = [](const glm::vec3& c) {
      return json::array({c.r, c.g, c.b});
    };
    return {{"color", color(look.color)},
            {"alpha", look.alpha},
            {"gloss", look.gloss},
            {"mark_color", color(look.mark_color)},
            {"mark_width", look.mark_width},
            {"finish", static_cast<int>(look.finish)},
            {"grain", look.grain},
            {"turned", look.turned},
            {"flat", look.flat},
            {"vivid", look.vivid},
            {"soft", look.soft},
            {"covers", look.covers},
            {"thin", look.thin},
            {"hidden", look.hidden},
            {"dashes", look.dashes}};
  }

  void add_mesh(const GltfMesh& from) {
    const std::vector<Vertex>& vertices = from.mesh->vertices;
    std::vector<float> positions, normals, colors, places;
    float reach = 0.0f;
    for (const Vertex& vertex : vertices)
      reach = std::max({reach, std::abs(vertex.position.x), std::abs(vertex.position.y)});
    const GltfMaterial& material = document_.materials[static_cast<std::size_t>(from.material)];
    for (const Vertex& vertex : vertices) {
      for (int i = 0; i < 3; ++i)
        positions.push_back(vertex.position[i]);
      glm::vec3 normal = vertex.normal;
      if (material.look.soft) {
        // the z of the normal is an opacity
        for (const float value : {1.0f, 1.0f, 1.0f, std::clamp(normal.z, 0.0f, 1.0f)})
          colors.push_back(value);
        normal = glm::vec3(0.0f, 0.0f, 1.0f);
      }
      normal = glm::normalize(normal);
      for (int i = 0; i < 3; ++i)
        normals.push_back(normal[i]);
      places.push_back(0.5f + 0.5f * vertex.position.x / reach);
      places.push_back(0.5f - 0.5f * vertex.position.y / reach);
    }
    tinygltf::Primitive primitive;
    primitive.mode = TINYGLTF_MODE_TRIANGLES;
    primitive.material = from.material;
    const int target = TINYGLTF_TARGET_ARRAY_BUFFER;
    const auto [shape, added] = shapes_.emplace(from.mesh.get(), Shape{});
    if (added) {
      shape->second = {add_accessor(positions, 3, TINYGLTF_TYPE_VEC3, target),
                       add_accessor(normals, 3, TINYGLTF_TYPE_VEC3, target),
                       add_indices(from.mesh->indices, vertices.size())};
      add_range(shape->second.positions, positions, 3);
    }
    primitive.attributes["POSITION"] = shape->second.positions;
    primitive.attributes["NORMAL"] = shape->second.normals;
    primitive.indices = shape->second.indices;
    if (!colors.empty())
      primitive.attributes["COLOR_0"] = add_accessor(colors, 4, TINYGLTF_TYPE_VEC4, target);
    if (!from.texture.empty()) {
      primitive.attributes["TEXCOORD_0"] = add_accessor(places, 2, TINYGLTF_TYPE_VEC2, target);
      add_texture(from.texture, from.material);
    }
    tinygltf::Mesh mesh;
    mesh.name = from.name;
    mesh.primitives.push_back(primitive);
    model_.meshes.push_back(mesh);
  }

  // tubes along paths of as many points are triangles of the same corners
  int add_indices(const std::vector<std::uint32_t>& indices, std::size_t vertices) {
    const auto [known, added] = indices_.emplace(indices, 0);
    if (added) known->second = new_indices(indices, vertices);
    return known->second;
  }

  int new_indices(const std::vector<std::uint32_t>& indices, std::size_t vertices) {
    tinygltf::Accessor accessor;
    accessor.type = TINYGLTF_TYPE_SCALAR;
    accessor.count = indices.size();
    const int target = TINYGLTF_TARGET_ELEMENT_ARRAY_BUFFER;
    if (vertices < 65535) {
      const std::vector<std::uint16_t> narrow(indices.begin(), indices.end());
      accessor.bufferView = add_bytes(narrow.data(), 2 * narrow.size(), target);
      accessor.componentType = TINYGLTF_COMPONENT_TYPE_UNSIGNED_SHORT;
    } else {
      accessor.bufferView = add_bytes(indices.data(), 4 * indices.size(), target);
      accessor.componentType = TINYGLTF_COMPONENT_TYPE_UNSIGNED_INT;
    }
    model_.accessors.push_back(accessor);
    return static_cast<int>(model_.accessors.size()) - 1;
  }

  void add_texture(const std::string& png, int material) {
    auto& factor = model_.materials[static_cast<std::size_t>(material)].pbrMetallicRoughness;
    const auto [found, added] = textures_.emplace(png, static_cast<int>(model_.textures.size()));
    if (added) {
      tinygltf::Image image;
      image.bufferView = add_bytes(png.data(), png.size(), 0);
      image.mimeType = "image/png";
      image.name = "marks";
      model_.images.push_back(image);
      if (model_.samplers.empty()) {
        tinygltf::Sampler sampler;
        sampler.minFilter = TINYGLTF_TEXTURE_FILTER_LINEAR_MIPMAP_LINEAR;
        sampler.magFilter = TINYGLTF_TEXTURE_FILTER_LINEAR;
        sampler.wrapS = sampler.wrapT = TINYGLTF_TEXTURE_WRAP_CLAMP_TO_EDGE;
        model_.samplers.push_back(sampler);
      }
      tinygltf::Texture texture;
      texture.source = static_cast<int>(model_.images.size()) - 1;
      texture.sampler = 0;
      model_.textures.push_back(texture);
    }
    factor.baseColorTexture.index = found->second;
  }

  void add_camera(const GltfCamera& from) {
    tinygltf::Camera camera;
    camera.name = from.name;
    camera.type = "perspective";
    camera.perspective.aspectRatio = from.aspect;
    camera.perspective.yfov = from.yfov;
    camera.perspective.znear = from.znear;
    camera.perspective.zfar = from.zfar;
    model_.cameras.push_back(camera);
  }

  void add_light(const GltfLight& from) {
    tinygltf::Light light;
    light.name = from.name;
    light.type = "directional";
    light.color = {1.0, 1.0, 1.0};
    light.intensity = from.intensity;
    model_.lights.push_back(light);
  }

  int accessor_of(const Numbers& numbers, int components, int type) {
    const auto [found, added] = accessors_.emplace(numbers.get(), 0);
    if (added) {
      found->second = add_accessor(*numbers, components, type, 0);
      if (components == 1) add_range(found->second, *numbers, 1);
    }
    return found->second;
  }

  void add_track(const GltfTrack& track,
                 const char* path,
                 int components,
                 tinygltf::Animation& into) {
    if (!track.values) return;
    const int type = components == 4 ? TINYGLTF_TYPE_VEC4 : TINYGLTF_TYPE_VEC3;
    const auto key = std::make_pair(track.times.get(), track.values.get());
    const auto [found, added] = samplers_.emplace(key, static_cast<int>(into.samplers.size()));
    if (added) {
      tinygltf::AnimationSampler sampler;
      sampler.input = accessor_of(track.times, 1, TINYGLTF_TYPE_SCALAR);
      sampler.output = accessor_of(track.values, components, type);
      sampler.interpolation = track.steps ? "STEP" : "LINEAR";
      into.samplers.push_back(sampler);
    }
    tinygltf::AnimationChannel channel;
    channel.sampler = found->second;
    channel.target_node = static_cast<int>(model_.nodes.size());
    channel.target_path = path;
    into.channels.push_back(channel);
  }

  void add_node(const GltfNode& from, tinygltf::Scene& scene, tinygltf::Animation& animation) {
    tinygltf::Node node;
    node.name = from.name;
    const Vec3& at = from.translation;
    const Quat& turn = from.rotation;
    if (!at.isZero(0.0)) node.translation = {at.x(), at.y(), at.z()};
    if (turn.coeffs() != Quat::Identity().coeffs()) {
      // of 1 and a rounding error, readers complain
      for (const double part : {turn.x(), turn.y(), turn.z(), turn.w()})
        node.rotation.push_back(std::clamp(part, -1.0, 1.0));
    }
    if (!from.scale.isOnes(0.0)) node.scale = {from.scale.x(), from.scale.y(), from.scale.z()};
    node.mesh = from.mesh;
    node.camera = from.camera;
    if (from.light >= 0) {
      node.extensions["KHR_lights_punctual"] =
          tinygltf::Value(tinygltf::Value::Object{{"light", tinygltf::Value(from.light)}});
    }
    if (!from.extras.empty()) node.extras = value_of(from.extras);
    add_track(from.translated, "translation", 3, animation);
    add_track(from.rotated, "rotation", 4, animation);
    add_track(from.scaled, "scale", 3, animation);
    const int index = static_cast<int>(model_.nodes.size());
    model_.nodes.push_back(node);
    if (from.parent < 0) {
      scene.nodes.push_back(index);
    } else {
      model_.nodes[static_cast<std::size_t>(from.parent)].children.push_back(index);
    }
  }

  const GltfDocument& document_;
  tinygltf::Model model_;
  struct Shape {
    int positions, normals, indices;  // accessors
  };
  std::map<const void*, Shape> shapes_;
  std::map<std::vector<std::uint32_t>, int> indices_;  // accessors
  std::map<const void*, int> accessors_;
  std::map<std::pair<const void*, const void*>, int> samplers_;
  std::map<std::string, int> textures_;
  bool unlit_ = false;
};

}  // namespace

std::string glb_of(const GltfDocument& document) {
  return Writer(document).bytes();
}

}  // namespace polhode
