// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/base/Result.h"

#include <glm/glm.hpp>

#include <QString>

#include <cstdint>
#include <optional>
#include <vector>

namespace core {

/// One surface as a file has it.
struct ReadMeshPart {
    QString name; ///< empty where the format knows none
    std::optional<std::uint32_t> rgb; ///< 0xRRGGBB
    std::optional<int> label;
    std::vector<glm::vec3> vertices;
    std::vector<glm::uvec3> triangles;
};

struct ReadMesh {
    QString space; ///< "LPS" or "RAS"; empty where the file does not say
    std::vector<ReadMeshPart> parts;
};

// Readers that share nothing with MeshWriter.h. They take what other programs write, as far as it
// is triangles or flat faces (which are fanned out); polygons must be convex. What else a file
// holds, normals and textures say, is passed over. Whole files are in memory; any thread.
// Errors: FileUnreadable, FileTruncated, UnsupportedFormat; all name the file.

/// By the ending of the file's name: .stl, .obj, .ply, .glb.
[[nodiscard]] Result<ReadMesh> readMesh(const QString& path);
/// Whether a file's name has one of these endings.
[[nodiscard]] bool isMeshName(const QString& path);

/// Binary and text; the text's solids are parts.
[[nodiscard]] Result<ReadMesh> readStl(const QString& path);
/// A part for every object, or group.
[[nodiscard]] Result<ReadMesh> readObj(const QString& path);
/// Binary of either byte order, and text. Parts where the comments of writePly() tell them.
[[nodiscard]] Result<ReadMesh> readPly(const QString& path);
/// What writeGltf() writes; refuses the rest.
[[nodiscard]] Result<ReadMesh> readGltf(const QString& path);

} // namespace core
