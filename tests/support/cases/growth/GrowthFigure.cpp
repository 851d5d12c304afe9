// SPDX-License-Identifier: Apache-2.0
#include "tests/support/cases/growth/GrowthFigure.h"

#include "core/document/Piece.h"
#include "core/edits/kinds/growth/PlugLeak.h"
#include "core/edits/kinds/growth/ShrinkAt.h"
#include "tests/support/cases/growth/RealGrowths.h"
#include "tests/support/scenes/PlainEdits.h"

#include <algorithm>

using namespace core;

namespace test {

namespace {

const glm::ivec2 panelSize(300, 284);

} // namespace

GrowthFigure::GrowthFigure(SculptStage& stage)
    : m_stage(stage)
{
}

QString GrowthFigure::does(const Edit& edit)
{
    m_actions += userActions(edit, geometry());
    return m_stage.apply(edit);
}

QString GrowthFigure::seeds(int label, const std::vector<glm::ivec3>& corners)
{
    return does(test::seedAt(label, placesOf(geometry(), strokeVoxels(corners))));
}

QString GrowthFigure::seeds(
    int label, const gpu::VolumeScene& scene, const std::vector<glm::dvec2>& pathMm)
{
    return does(test::seedAt(label, placesOf(geometry(), m_stage.seenVoxels(scene, pathMm))));
}

QString GrowthFigure::shrinksAt(const std::vector<glm::ivec3>& corners)
{
    return does(ShrinkAt{.pointsLps = placesOf(geometry(), strokeVoxels(corners))});
}

QString GrowthFigure::plugs(const glm::ivec3& voxel)
{
    return does(PlugLeak{.pointLps = place(glm::dvec3(voxel))});
}

void GrowthFigure::shows(const gpu::VolumeScene& scene, const gpu::SegmentDisplay& segments)
{
    if (panelsWanted())
        m_panels.push_back(m_stage.draw(scene, panelSize, segments));
}

void GrowthFigure::sketched(const OrthographicView& view, const std::vector<glm::dvec2>& pathMm,
    bool closed, std::uint32_t rgb)
{
    if (!m_panels.empty())
        drawSketch(m_panels.back(), view, pathMm, closed, rgb);
}

void GrowthFigure::showsPieces(gpu::VolumeScene scene, const std::vector<std::uint32_t>& rgb)
{
    for (const Piece& piece : m_stage.session().document().pieces) {
        scene.pieces.push_back({.id = piece.id,
            .segment = piece.segment,
            .shownFromTrue = shownFromTrue(piece, geometry()),
            .rgb = rgb[std::size_t(piece.segment - 1)],
            .solid = true});
    }
    shows(scene);
}

bool GrowthFigure::kept(const char* name) const
{
    return keepPanels(m_panels, name);
}

std::vector<std::uint8_t> GrowthFigure::mask(std::uint8_t label)
{
    return maskOf(m_stage.voxels(Field::Labels, 0), label);
}

double GrowthFigure::mL(std::uint8_t label)
{
    const std::vector<std::uint8_t> voxels = mask(label);
    return double(std::count(voxels.begin(), voxels.end(), std::uint8_t(1)))
        * geometry().voxelVolumeMm3() / 1000.0;
}

const VolumeGeometry& GrowthFigure::geometry() const
{
    return m_stage.study().volume.geometry;
}

glm::dvec3 GrowthFigure::place(const glm::dvec3& voxel) const
{
    return geometry().toWorld(voxel);
}

gpu::SegmentDisplay inColours(const std::vector<std::uint32_t>& rgb)
{
    gpu::SegmentDisplay shown;
    for (std::size_t i = 0; i < rgb.size(); ++i) {
        shown.rgb[i + 1] = rgb[i];
        shown.visible[i + 1] = rgb[i] != 0;
    }
    return shown;
}

double shareInside(const std::vector<std::uint8_t>& a, const std::vector<std::uint8_t>& b)
{
    std::size_t all = 0;
    std::size_t both = 0;
    for (std::size_t i = 0; i < a.size(); ++i) {
        all += a[i] != 0 ? 1 : 0;
        both += a[i] != 0 && b[i] != 0 ? 1 : 0;
    }
    return all == 0 ? 0.0 : double(both) / double(all);
}

std::vector<std::uint8_t> within(std::vector<std::uint8_t> mask, const glm::ivec3& size,
    const glm::ivec3& low, const glm::ivec3& high)
{
    for (std::size_t i = 0; i < mask.size(); ++i) {
        const glm::ivec3 at(int(i) % size.x, int(i) / size.x % size.y, int(i) / (size.x * size.y));
        if (glm::any(glm::lessThan(at, low)) || glm::any(glm::greaterThan(at, high)))
            mask[i] = 0;
    }
    return mask;
}

} // namespace test
