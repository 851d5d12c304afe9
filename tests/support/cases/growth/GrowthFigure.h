// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/edits/kinds/Edit.h"
#include "tests/support/scenes/FigurePanels.h"
#include "tests/support/scenes/SculptStage.h"

#include <QString>

namespace test {

/// Makes a figure of a growth: carries out and counts what the user does, and draws pictures if
/// requested. Functions that return a text return an error, or an empty text.
class GrowthFigure {
public:
    explicit GrowthFigure(SculptStage& stage);

    [[nodiscard]] QString does(const core::Edit& edit);
    /// Draws a stroke of seeds on a slice, along voxels.
    [[nodiscard]] QString seeds(int label, const std::vector<glm::ivec3>& corners);
    /// Draws a stroke of seeds on what is seen in 3D.
    [[nodiscard]] QString seeds(
        int label, const gpu::VolumeScene& scene, const std::vector<glm::dvec2>& pathMm);
    [[nodiscard]] QString shrinksAt(const std::vector<glm::ivec3>& corners);
    [[nodiscard]] QString plugs(const glm::ivec3& voxel);

    void shows(const gpu::VolumeScene& scene, const gpu::SegmentDisplay& segments = {});
    /// Draws a sketch over the last picture.
    void sketched(const core::OrthographicView& view, const std::vector<glm::dvec2>& pathMm,
        bool closed, std::uint32_t rgb = 0xFFD040);
    /// Shows the segments that were pasted as pieces in these colours, wherever they are.
    void showsPieces(gpu::VolumeScene scene, const std::vector<std::uint32_t>& rgb);
    [[nodiscard]] bool kept(const char* name) const;

    [[nodiscard]] std::vector<std::uint8_t> mask(std::uint8_t label);
    [[nodiscard]] double mL(std::uint8_t label);
    [[nodiscard]] int actions() const { return m_actions; }
    [[nodiscard]] const core::VolumeGeometry& geometry() const;
    [[nodiscard]] glm::dvec3 place(const glm::dvec3& voxel) const;

private:
    SculptStage& m_stage;
    std::vector<QImage> m_panels;
    int m_actions = 0;
};

/// Shows the segments 1, 2 … in these colours; black: not shown.
[[nodiscard]] gpu::SegmentDisplay inColours(const std::vector<std::uint32_t>& rgb);

/// The fraction of A that lies in B.
[[nodiscard]] double shareInside(
    const std::vector<std::uint8_t>& a, const std::vector<std::uint8_t>& b);

/// The part of a mask between two voxels, inclusive.
[[nodiscard]] std::vector<std::uint8_t> within(std::vector<std::uint8_t> mask,
    const glm::ivec3& size, const glm::ivec3& low, const glm::ivec3& high);

} // namespace test
