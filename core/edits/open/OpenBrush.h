// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/edits/open/OpenStroke.h"
#include "core/engine/StrokeExtensions.h"

namespace core {

struct BrushPath;
struct VolumeGeometry;

/// How the path of a brush becomes that of the engine.
struct BrushRule {
    bool followsEdges = false; ///< the engine must know the voxels under the pen (CapsulePath)
    bool ofTolerance = false; ///< as PartPressures::ofTolerance
};

/// The whole path of a brush in an engine's integers.
[[nodiscard]] CapsulePath wholeBrushPath(
    const BrushPath& path, BrushRule rule, const VolumeGeometry& geometry);

/// The open stroke of a brush that paints, carves or sets barriers. It takes further points of its
/// path (PathPoints).
class OpenBrush final : public OpenStroke {
public:
    explicit OpenBrush(BrushPath& path, BrushRule rule = {});

    [[nodiscard]] Told begin(
        const EngineEdit& command, const Document& document, bool isWhole) override;
    [[nodiscard]] Result<Told> extend(
        const StrokeExtension& extension, const Document& document) override;

private:
    BrushPath& m_path;
    BrushRule m_rule;
    bool m_hasBegun = false;
};

} // namespace core
