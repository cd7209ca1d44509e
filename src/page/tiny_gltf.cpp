// SPDX-License-Identifier: MIT
// tinygltf for pages, which have no files: it is a library of Debian elsewhere.
#include <fstream>

#define TINYGLTF_IMPLEMENTATION
#define TINYGLTF_NO_STB_IMAGE
#define TINYGLTF_NO_STB_IMAGE_WRITE
#define TINYGLTF_NO_EXTERNAL_IMAGE
#define TINYGLTF_NO_FS
#include <tiny_gltf.h>

namespace tinygltf {

bool FileExists(const std::string&, void*) {
  return false;
}
std::string ExpandFilePath(const std::string& path, void*) {
  return path;
}
bool ReadWholeFile(std::vector<unsigned char>*, std::string*, const std::string&, void*) {
  return false;
}
bool WriteWholeFile(std::string*, const std::string&, const std::vector<unsigned char>&, void*) {
  return false;
}
bool LoadImageData(
    Image*, const int, std::string*, std::string*, int, int, const unsigned char*, int, void*) {
  return false;
}
bool WriteImageData(
    const std::string*, const std::string*, const Image*, bool, std::string*, void*) {
  return false;
}

}  // namespace tinygltf
