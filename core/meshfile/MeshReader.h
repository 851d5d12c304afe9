// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/base/Result.h"

#include <glm/glm.hpp>

#include <QString>

#include <cstdint>
#include <optional>
#include <vector>

namespace core {

/// One surface as read from a file.
struct ReadMeshPart {
    QString name; ///< empty if the format has no names
    std::optional<std::uint32_t> rgb; ///< 0xRRGGBB
    std::optional<int> label;
    std::vector<glm::vec3> vertices;
    std::vector<glm::uvec3> triangles;
};

/// The contents of a file of surfaces.
struct ReadMesh {
    QString space; ///< "LPS" or "RAS"; empty if the file does not state it
    std::vector<ReadMeshPart> parts;
};

// Readers that share no code with MeshWriter.h. They accept files of other programs as far as these
// consist of triangles or flat faces (which become fans of triangles); polygons must be convex.
// Everything else in a file, such as normals and textures, is skipped. Files are read completely
// into memory; any thread. Errors: FileUnreadable, FileTruncated, UnsupportedFormat; all name the
// file.

/// Chooses the reader by the file name extension: .stl, .obj, .ply, .glb.
[[nodiscard]] Result<ReadMesh> readMesh(const QString& path);
/// Whether a file name has one of these extensions.
[[nodiscard]] bool isMeshName(const QString& path);

/// Binary and text; the solids of a text file are parts.
[[nodiscard]] Result<ReadMesh> readStl(const QString& path);
/// One part for every object or group.
[[nodiscard]] Result<ReadMesh> readObj(const QString& path);
/// Binary of either byte order, and text. Parts are recognised by the comments that writePly()
/// writes.
[[nodiscard]] Result<ReadMesh> readPly(const QString& path);
/// Reads what writeGltf() writes, and refuses everything else.
[[nodiscard]] Result<ReadMesh> readGltf(const QString& path);

} // namespace core
