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

/// Readers of what MeshWriter.h writes, which share nothing with it: they know the formats as far
/// as that, and refuse the rest. Errors: FileUnreadable.
Result<ReadMesh> readStl(const QString& path);
Result<ReadMesh> readObj(const QString& path);
Result<ReadMesh> readPly(const QString& path);
Result<ReadMesh> readGltf(const QString& path);

} // namespace core
