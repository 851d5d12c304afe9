// SPDX-License-Identifier: Apache-2.0
#include "gpu/render/SlicePass.h"

#include "gpu/fields/bricks/BrickField.h"
#include "gpu/fields/textures/PieceTextures.h"
#include "gpu/fields/textures/VolumeTextures.h"
#include "gpu/scene/WindowMapping.h"

#include <span>
#include <vector>

namespace gpu {

namespace {

constexpr unsigned labeled = 1;
constexpr unsigned carved = 2;
constexpr unsigned barriers = 4;
constexpr unsigned warned = 8;
constexpr unsigned atTolerance = 16;
constexpr unsigned cutPreview = 32;
constexpr unsigned chunked = 64;
constexpr unsigned pieces = 128;
constexpr unsigned oneMorePlane = 256; // 0 to 3 times
constexpr GLuint furtherLabelsUnit = 30; // slice.frag; those of the next planes follow
constexpr std::size_t mostPieces = 64; // slice.frag; as many as a document has

/// Pieces that layers have cut out; those of segments are seen as segments.
std::vector<const PieceTextures::Entry*> cutPieces(const PieceTextures& textures)
{
    std::vector<const PieceTextures::Entry*> cut;
    for (const auto& [source, entry] : textures.entries()) {
        if (source.layer != 0 && !entry.filled.empty() && cut.size() < mostPieces)
            cut.push_back(&entry);
    }
    return cut;
}

void setPieces(Program& program, const std::vector<const PieceTextures::Entry*>& cut)
{
    std::vector<glm::vec4> low;
    std::vector<glm::vec4> high;
    std::vector<glm::vec4> shift;
    for (const PieceTextures::Entry* entry : cut) {
        low.emplace_back(glm::vec3(entry->box.minimum), 0.0f);
        high.emplace_back(glm::vec3(entry->box.maximum), 0.0f);
        shift.emplace_back(glm::vec3(entry->place - entry->box.minimum), 0.0f);
    }
    program.set("pieceCount", int(cut.size()))
        .set("pieceLow", std::span<const glm::vec4>(low))
        .set("pieceHigh", std::span<const glm::vec4>(high))
        .set("pieceShift", std::span<const glm::vec4>(shift));
}

bool isCubic(const SliceScene& scene, const PassTarget& target)
{
    return scene.interpolation == Interpolation::Cubic && scene.slab.mode == SlabMode::Off
        && target.cubic;
}

/// @param perMm index per mm along the slice's normal
void setSlab(Program& program, const SceneSlab& slab, const glm::dvec3& perMm)
{
    const double first = slab.offsetMm - slab.reach * slab.stepMm;
    program.set("slabFirst", glm::vec3(perMm * first))
        .set("slabStep", glm::vec3(perMm * slab.stepMm))
        .set("slabCount", 2 * slab.reach + 1)
        .set("slabMode", int(slab.mode));
}

} // namespace

SlicePass::SlicePass(const ShaderLibrary& library)
    : m_library(library)
{
}

Program& SlicePass::programFor(unsigned form, unsigned variant)
{
    const auto has = [variant](unsigned part) { return (variant & part) != 0 ? 1 : 0; };
    const auto make = [&] {
        return std::make_shared<Program>(m_library,
            GraphicsProgramOptions{.label = "slice",
                .fragmentPath = "render/slice.frag",
                .defines = {{"LABELED", has(labeled)}, {"CARVED", has(carved)},
                    {"BARRIERS", has(barriers)}, {"WARNED", has(warned)},
                    {"AT_TOLERANCE", has(atTolerance)}, {"CUT_PREVIEW", has(cutPreview)},
                    {"CHUNKS", has(chunked)}, {"PIECES", has(pieces)},
                    {"LABEL_PLANES", int(variant / oneMorePlane) + 1},
                    {"CUBIC", (form & Cubic) != 0 ? 1 : 0},
                    {"NEAREST", (form & Nearest) != 0 ? 1 : 0},
                    {"PLANE", (form & OnPlane) != 0 ? 1 : 0},
                    {"SLAB", (form & Slab) != 0 ? 1 : 0}}});
    };
    return *m_programs.of({form, variant}, make);
}

void SlicePass::prepare(VolumeTextures& volume, const SliceScene& scene,
    const SegmentDisplay& segments, const Palette& palette, const PassTarget& target,
    const ChunkTextures* chunks)
{
    const glm::dmat4 worldToIndex = volume.geometry().worldToIndex();
    const glm::dmat3 directions(worldToIndex);
    const glm::dvec3 perX = directions * (scene.rightLps * scene.mmPerPixel);
    const glm::dvec3 perY = directions * (scene.downLps * scene.mmPerPixel);
    const glm::dvec2 middle = glm::dvec2(target.frameSize) * 0.5;
    const glm::dvec3 base = glm::dvec3(worldToIndex * glm::dvec4(scene.centreLps, 1.0))
        - perX * middle.x - perY * middle.y;
    const bool slab = scene.slab.mode != SlabMode::Off;
    Program& program =
        prepareForm(slab ? unsigned(Slab) : 0U, volume, scene, segments, palette, target, chunks);
    if (slab)
        setSlab(program, scene.slab, directions * glm::cross(scene.rightLps, scene.downLps));
    program.set("base", glm::vec3(base))
        .set("perX", glm::vec3(perX))
        .set("perY", glm::vec3(perY))
        .use();
}

Program& SlicePass::prepareOnPlane(VolumeTextures& volume, const SliceScene& look,
    const SegmentDisplay& segments, const Palette& palette, const PassTarget& target,
    const ChunkTextures* chunks)
{
    return prepareForm(OnPlane, volume, look, segments, palette, target, chunks);
}

Program& SlicePass::prepareForm(unsigned where, VolumeTextures& volume, const SliceScene& scene,
    const SegmentDisplay& segments, const Palette& palette, const PassTarget& target,
    const ChunkTextures* chunks)
{
    unsigned form = where;
    if (isCubic(scene, target))
        form |= Cubic;
    if (scene.interpolation == Interpolation::Nearest)
        form |= Nearest;
    volume.intensity().bindUnit(0);
    volume.radiation().bindUnit(1);
    volume.labels().bindUnit(3);
    palette.texture().bindUnit(7);
    const Texture3D* tolerances =
        segments.atTolerance ? volume.tolerances(segments.atTolerance->label) : nullptr;
    BrickField* words = volume.seedWords();
    unsigned variant = (volume.touched(VolumeField::Labels) ? labeled : 0)
        + (volume.touched(VolumeField::Radiation) ? carved : 0);
    if (words) {
        variant += (volume.touched(VolumeField::Barriers) && segments.showBarriers ? barriers : 0)
            + (palette.warns() ? warned : 0);
        if (tolerances && volume.growthPlace()) {
            variant |= labeled | atTolerance;
            tolerances->bindUnit(13);
        }
        words->atlas().bindUnit(14);
        words->pageTable().bindUnit(15);
    }
    if (BrickField* marks = volume.cutPreview()) {
        variant += cutPreview;
        marks->pageTable().bindUnit(16);
        marks->atlas().bindUnit(17);
    }
    // A picture without labels is the same with any number of planes.
    const std::vector<const Texture3D*> planes = volume.labelPlanes();
    for (std::size_t further = 1; further < planes.size() && (variant & labeled) != 0; ++further) {
        planes[further]->bindUnit(furtherLabelsUnit + GLuint(further) - 1);
        variant += oneMorePlane;
    }
    if (chunks)
        variant += chunked;
    const std::vector<const PieceTextures::Entry*> cut = cutPieces(volume.pieces());
    if (!cut.empty() && scene.showCarved)
        variant += pieces;
    Program& program = programFor(form, variant);
    if ((variant & pieces) != 0) {
        volume.pieces().footprints().bindUnit(9);
        setPieces(program, cut);
    }
    if (chunks)
        chunks->bind(program, *scene.chunks,
            (form & OnPlane) != 0 ? ChunkTextures::Drawn::Bodies : ChunkTextures::Drawn::Areas);
    if ((variant & labeled) != 0 && planes.size() > 1) {
        constexpr unsigned none = 255;
        const std::optional<std::size_t> place = volume.growthPlace();
        program.set("growthPlace", place ? unsigned(*place) : none);
    }
    if ((variant & atTolerance) != 0)
        program.set("toleranceLabel", unsigned(segments.atTolerance->label))
            .set("tolerance", unsigned(segments.atTolerance->tolerance));
    m_colours.bind(program, scene.colours);
    program.set("pixelScale", target.pixelScale)
        .set("pixelJitter", target.pixelJitter)
        .set("window", glm::vec2(greyOfTexel(volume.encoding(), scene.window)))
        .set("inverted", scene.inverted)
        .set("showCarved", scene.showCarved)
        .set("carvedAsHole", scene.carvedAsHole)
        .set("warnAfter", segments.warnAfterGeneration)
        .set("fillOpacity", segments.fillOpacity)
        .set("outlineWidth", segments.outlineWidthPixels);
    return program;
}

} // namespace gpu
