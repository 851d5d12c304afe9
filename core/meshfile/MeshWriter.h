// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/base/Result.h"

#include <glm/glm.hpp>

#include <QString>

#include <cstdint>
#include <vector>

namespace core {

/// One surface as it goes into a file: mm, triangles to the left seen from outside.
struct MeshPart {
    QString name;
    std::uint32_t rgb = 0; ///< 0xRRGGBB
    std::uint8_t label = 0;
    std::vector<glm::vec3> vertices;
    std::vector<glm::uvec3> triangles;
};

/// What is the same in all four: creates or overwrites the file; @p space ("LPS", "RAS") names the
/// axes of the numbers in the file's comment. Errors: FileUnwritable, UnsupportedFormat (more than
/// the format can count).

/// Binary; all parts in one, which is all that the format knows. "SPACE=LPS" stands in the header.
Result<void> writeStl(
    const QString& path, const std::vector<MeshPart>& parts, const QString& space);
/// An object a part, vertices with their colour.
Result<void> writeObj(
    const QString& path, const std::vector<MeshPart>& parts, const QString& space);
/// Binary, little endian; vertices with their colour, faces with their part's label, a comment a
/// part that says which faces are its own.
Result<void> writePly(
    const QString& path, const std::vector<MeshPart>& parts, const QString& space);
/// Binary (.glb), a node and a material a part. The numbers are as in the other formats; the node
/// above them turns and scales them to glTF's metres with Y up (glTF 2.0, 3.6.2).
Result<void> writeGltf(
    const QString& path, const std::vector<MeshPart>& parts, const QString& space);

} // namespace core
