// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/meshfile/MeshReader.h"

#include <QByteArray>

#include <vector>

namespace core {

// Parts that the readers of the formats share.

/// The greatest size of a file: more than any mask needs, but less than memory.
constexpr qsizetype mostMeshBytes = qsizetype(2) << 30;

[[nodiscard]] Result<QByteArray> meshBytes(const QString& path);

[[nodiscard]] tl::unexpected<Error> unreadableMesh(const QString& path, const Clause& reason);

/// The value in "… SPACE=LPS …", which 3D Slicer and our own writers write; empty if it is missing.
[[nodiscard]] QString spaceIn(const QByteArray& text);

/// Parses a whole word as a number; false also for numbers that are not finite.
[[nodiscard]] bool isNumber(QByteArrayView word, double& value);

/// The words of a line, separated by blanks.
[[nodiscard]] std::vector<QByteArrayView> wordsOf(QByteArrayView line);

/// The colour of a part: that of its vertices, if it is the same for all of them.
class CommonColour {
public:
    void add(std::uint32_t rgb);
    [[nodiscard]] std::optional<std::uint32_t> rgb() const { return m_same ? m_rgb : std::nullopt; }

private:
    std::optional<std::uint32_t> m_rgb;
    bool m_same = true;
};

/// Makes a part from triangles that index the vertices of the whole file; it gets only the vertices
/// that they use.
/// @param colours one per vertex, or empty
[[nodiscard]] ReadMeshPart partWithOwnVertices(const std::vector<glm::vec3>& vertices,
    const std::vector<std::uint32_t>& colours, std::vector<glm::uvec3> triangles);

} // namespace core
