// SPDX-License-Identifier: Apache-2.0
#include "gpu/render/raycast/RaycastPass.h"

#include "gpu/fields/bricks/BarrierBricks.h"
#include "gpu/fields/bricks/BrickField.h"
#include "gpu/fields/textures/VolumeTextures.h"
#include "gpu/render/PlanePass.h"
#include "gpu/render/SurfacePass.h"
#include "gpu/render/parts/TileParts.h"
#include "gpu/render/raycast/ContextDrawing.h"
#include "gpu/scene/ViewFrame.h"
#include "gpu/scene/WindowMapping.h"

#include <algorithm>
#include <cmath>
#include <tuple>

namespace gpu {

namespace {

/// Steps in units of the finest spacing. Surfaces are refined by bisection, so the step only has to
/// find them; the other modes refine by accumulated, jittered pictures.
/// @param voxelTrue of segments, whose corners long steps would miss
double stepMm(const VolumeScene& scene, const core::VolumeGeometry& geometry, bool voxelTrue)
{
    const RenderMode mode = scene.mode;
    const glm::dvec3 spacing = geometry.spacingMm();
    const double finest = std::min({spacing.x, spacing.y, spacing.z}) * PieceSet::finestZoom(scene);
    switch (mode) {
    case RenderMode::Surface:
        return (voxelTrue ? 0.3 : 0.8) * finest;
    case RenderMode::Dvr:
        return (voxelTrue ? 0.3 : 0.8) * finest;
    case RenderMode::Mip:
        return 0.8 * finest;
    case RenderMode::Xray:
        break; // a mean: every voxel once
    }
    return finest;
}

constexpr std::array<const char*, renderModes> labels{
    "surface", "volume rendering", "MIP", "X-ray"};

/// Of cut faces where a scene names no colours: marrow to bone.
TransferFunction materialColours(double from, double to)
{
    return {{{from, 0xB27059, 0.0}, {to, 0xF6E2C1, 1.0}}};
}

} // namespace

RaycastPass::RaycastPass(const ShaderLibrary& library)
    : m_library(library)
    , m_seeds(library)
{
}

Program& RaycastPass::oftenProgram(std::size_t variant)
{
    const std::size_t mode = variant / variants;
    const std::size_t kind = variant % variants / 2;
    Program& program = m_programs[variant];
    if (!program)
        program = Program(m_library,
            {.label = labels[mode],
                .fragmentPath = "render/raycast/raycast.frag",
                .defines = {{"MODE", int(mode)}, {"SCULPTED", kind > 0 ? 1 : 0},
                    {"SEGMENTS", kind > 1 ? 1 : 0}, {"CLIPPED", int(variant & 1)}, {"PIECES", 0},
                    {"SEEDS", 0}, {"BARRIERS", 0}, {"WARNED", 0}, {"CUT_PREVIEW", 0}, {"SHEETS", 0},
                    {"CHUNKS", 0}, {"CONTEXT", 0}, {"SEGMENT_LOOKS", 0}}});
    return program;
}

Program& RaycastPass::seldomProgram(const VolumeScene& scene, const Seldom& with)
{
    const auto mode = std::size_t(scene.mode);
    const bool clipped = scene.clip.any();
    const bool home = with.pieces && m_pieces.anyAtHome();
    const bool sculpted = with.pieces || with.kind != RayBlocks::Kind::Plain;
    const bool segments = with.pieces || with.kind > RayBlocks::Kind::Carved;
    const bool looks = with.segmentLooks && segments;
    const int context = contextVariant(scene);
    std::size_t variant = 3 * mode + std::size_t(context);
    for (const bool part :
        {clipped, home, sculpted, segments, with.pieces, with.seeds, with.barriers, with.warned,
            with.cutPreview, with.suspended, with.sheets, with.chunks, looks})
        variant = 2 * variant + std::size_t(part);
    const auto make = [&] {
        return std::make_shared<Program>(m_library,
            GraphicsProgramOptions{.label = labels[mode],
                .fragmentPath = "render/raycast/raycast.frag",
                .defines = {{"MODE", int(mode)}, {"SCULPTED", int(sculpted)},
                    {"SEGMENTS", int(segments)}, {"CLIPPED", int(clipped)}, {"HOME", int(home)},
                    {"PIECES", int(with.pieces)}, {"SEEDS", int(with.seeds)},
                    {"BARRIERS", int(with.barriers)}, {"WARNED", int(with.warned)},
                    {"CUT_PREVIEW", int(with.cutPreview) + int(with.suspended)},
                    {"SHEETS", int(with.sheets)}, {"CHUNKS", int(with.chunks)},
                    {"CONTEXT", context}, {"SEGMENT_LOOKS", int(looks)}}});
    };
    return *m_seldomPrograms.of(variant, make);
}

std::size_t RaycastPass::variantOf(const VolumeScene& scene, RayBlocks::Kind kind)
{
    // An X-ray gains nothing by leaving segments out.
    if (scene.mode == RenderMode::Xray && kind == RayBlocks::Kind::Carved)
        kind = RayBlocks::Kind::Sculpted;
    return variants * std::size_t(scene.mode) + 2 * std::size_t(kind) + (scene.clip.any() ? 1 : 0);
}

Program& RaycastPass::programFor(RayBlocks::Kind kind, const VolumeScene& scene, const Seldom& with)
{
    const bool marked = with.warned || with.cutPreview || with.segmentLooks;
    if (kind == RayBlocks::Kind::Pieces || (kind == RayBlocks::Kind::Sculpted && marked))
        return seldomProgram(scene,
            {.pieces = kind == RayBlocks::Kind::Pieces,
                .warned = with.warned,
                .cutPreview = with.cutPreview,
                .sheets = with.sheets,
                .segmentLooks = with.segmentLooks});
    if (with.sheets || contextVariant(scene) != 0)
        return seldomProgram(scene, {.sheets = with.sheets, .kind = kind});
    const std::size_t variant = variantOf(scene, kind);
    m_warm[variant] = true;
    return oftenProgram(variant);
}

const RayBlocks& RaycastPass::blocksOf(
    VolumeTextures& volume, const VolumeScene& scene, const PassTarget& target)
{
    const bool same = scene == m_blocksScene && target.frameSize == m_blocksSize
        && target.pixelScale == m_blocksScale && volume.revision() == m_blocksRevision;
    if (same)
        return m_blocks;
    m_blocks = RayBlocks(volume, scene, target);
    m_blocksScene = scene;
    m_blocksSize = target.frameSize;
    m_blocksScale = target.pixelScale;
    m_blocksRevision = volume.revision();
    return m_blocks;
}

void RaycastPass::draw(VolumeTextures& volume, const VolumeScene& scene, const Palette& palette,
    const PassTarget& target, const Tile& tile, const VertexArray& noVertices,
    const RaySheets& sheets, const ChunkTextures* chunks)
{
    if (scene.context == Context::Hidden)
        drawMode(volume, segmentsAlone(scene), palette, target, tile, noVertices, sheets, chunks);
    else
        drawMode(volume, scene, palette, target, tile, noVertices, sheets, chunks);
}

void RaycastPass::drawMode(VolumeTextures& volume, const VolumeScene& scene, const Palette& palette,
    const PassTarget& target, const Tile& tile, const VertexArray& noVertices,
    const RaySheets& sheets, const ChunkTextures* chunks)
{
    m_voxelTrue = palette.voxelTrue();
    const bool pieces = m_pieces.set(volume, scene, stepMm(scene, volume.geometry(), m_voxelTrue));
    const bool seeds = m_seeds.set(volume, scene);
    BrickField* words = volume.seedWords();
    BrickField* cutPreview = words ? volume.cutPreview() : nullptr; // marks are of members
    const core::VoxelBox suspended =
        cutPreview && palette.showsSuspended() ? volume.suspended() : core::VoxelBox();
    const BarrierBricks* barriers = words && palette.showsBarriers() ? volume.barriers() : nullptr;
    if (barriers && !barriers->any())
        barriers = nullptr;
    const Seldom with{.pieces = pieces,
        .seeds = seeds,
        .barriers = barriers != nullptr,
        .warned = words && palette.warns(),
        .cutPreview = cutPreview != nullptr,
        .suspended = !suspended.empty(),
        .sheets = sheets.any(),
        .chunks = chunks != nullptr,
        .segmentLooks = palette.changesBodies()};
    Tile over;
    const auto overlay = [&over](const Tile& blocks) {
        over = over.size.x > 0 ? unionOf(over, blocks) : blocks;
    };
    if (seeds)
        overlay(m_seeds.blocksIn(scene, target));
    if (barriers)
        overlay(blocksAround(barriers->box(), volume.geometry(), scene, target));
    if (with.suspended)
        overlay(blocksAround(suspended, volume.geometry(), scene, target));
    if (chunks)
        overlay(blocksAround(scene.chunks->box, volume.geometry(), scene, target));
    const Tile overlaid = commonPart(tile, over);
    const bool sculpted = pieces || volume.cells().isSculpted();
    using Parts = std::array<std::vector<Tile>, RayBlocks::kinds>;
    Parts parts;
    Parts sheetParts; // where sheets may be seen
    Tile sheetBlocks = sheets.surface ? sheets.surface->blocks : Tile{};
    if (sheets.plane)
        sheetBlocks =
            sheets.surface ? unionOf(sheetBlocks, sheets.plane->blocks) : sheets.plane->blocks;
    const auto addTo = [&](Parts& into, const Tile& rest) {
        if (!sculpted) {
            into[std::size_t(RayBlocks::Kind::Plain)].push_back(rest);
            return;
        }
        const auto split = blocksOf(volume, scene, target).split(rest);
        for (std::size_t kind = 0; kind < into.size(); ++kind)
            into[kind].insert(into[kind].end(), split[kind].begin(), split[kind].end());
    };
    for (const Tile& rest : partsAround(tile, overlaid)) {
        const Tile near = sheets.any() ? commonPart(rest, sheetBlocks) : Tile{};
        if (near.size.x > 0)
            addTo(sheetParts, near);
        for (const Tile& apart : partsAround(rest, near))
            addTo(parts, apart);
    }
    const auto drawParts = [&](Program& program, const std::vector<Tile>& tiles) {
        prepare(program, volume, scene, palette, target);
        if (words) {
            words->atlas().bindUnit(14);
            words->pageTable().bindUnit(15);
            program.set("warnAfter", palette.warnAfterGeneration());
        }
        if (sheets.any())
            bindSheets(program, scene, sheets);
        if (cutPreview) {
            cutPreview->pageTable().bindUnit(16);
            cutPreview->atlas().bindUnit(17);
        }
        for (const Tile& part : tiles) {
            glScissor(part.minimum.x, part.minimum.y, part.size.x, part.size.y);
            noVertices.drawFullScreenTriangle();
        }
    };
    const auto drawKinds = [&](const Parts& kinds, const Seldom& seldom) {
        for (std::size_t kind = 0; kind < kinds.size(); ++kind) {
            if (kinds[kind].empty())
                continue;
            Program& program = programFor(RayBlocks::Kind(kind), scene, seldom);
            if (RayBlocks::Kind(kind) == RayBlocks::Kind::Pieces)
                m_pieces.bind(program, volume);
            drawParts(program, kinds[kind]);
        }
    };
    glEnable(GL_SCISSOR_TEST);
    drawKinds(sheetParts, with);
    Seldom apart = with;
    apart.sheets = false;
    drawKinds(parts, apart);
    if (overlaid.size.x > 0) {
        Program& program = seldomProgram(scene, with);
        if (pieces)
            m_pieces.bind(program, volume);
        if (seeds)
            m_seeds.bind(program);
        if (barriers) {
            barriers->texture().bindUnit(18);
            program.set("barrierLow", glm::vec3(barriers->box().minimum) - 1.0f)
                .set("barrierHigh", glm::vec3(barriers->box().maximum));
        }
        if (with.suspended)
            program.set("suspendedLow", glm::vec3(suspended.minimum) - 1.0f)
                .set("suspendedHigh", glm::vec3(suspended.maximum));
        if (chunks)
            chunks->bind(program, *scene.chunks, ChunkTextures::Drawn::Bodies);
        drawParts(program, {overlaid});
    }
    glDisable(GL_SCISSOR_TEST);
}

void RaycastPass::bindSheets(Program& program, const VolumeScene& scene, const RaySheets& sheets)
{
    if (!m_noSheet) {
        m_noSheet = Texture2D({.label = "no sheet"});
        m_noSheet.clear();
    }
    const auto [surface, plane] = sheets;
    (surface ? surface->colours : m_noSheet).bindUnit(19);
    (surface ? surface->ways : m_noSheet).bindUnit(20);
    (plane ? plane->colours : m_noSheet).bindUnit(21);
    (plane ? plane->ways : m_noSheet).bindUnit(22);
    program.set("surfaceThere", surface ? 1 : 0)
        .set("planeThere", plane ? 1 : 0)
        .set("surfaceOpacity", surface ? scene.surface->opacity : 0.0f)
        .set("surfaceBehind", surface ? scene.surface->behindOpacity : 0.0f)
        .set("planeBehind", plane ? scene.plane->behindOpacity : 0.0f);
}

void RaycastPass::warmUp(VolumeTextures& volume, const VolumeScene& scene, const Palette& palette,
    const PassTarget& target, const VertexArray& noVertices)
{
    // With a context that is not opaque all are compiled when they are first needed.
    if (contextVariant(scene) != 0)
        return;
    glEnable(GL_SCISSOR_TEST);
    glScissor(0, 0, 1, 1);
    for (const RayBlocks::Kind kind : {RayBlocks::Kind::Carved, RayBlocks::Kind::Sculpted}) {
        if (m_warm[variantOf(scene, kind)])
            continue;
        prepare(programFor(kind, scene, {}), volume, scene, palette, target);
        noVertices.drawFullScreenTriangle();
    }
    glDisable(GL_SCISSOR_TEST);
}

void RaycastPass::prepare(Program& active, VolumeTextures& volume, const VolumeScene& scene,
    const Palette& palette, const PassTarget& target)
{
    setRays(active, volume, scene, ViewFrame::of(scene, target.frameSize), target);
    if (scene.clip.any())
        setClip(active, volume, scene.clip);
    const VisibleCodes visible = setMode(active, volume, scene);
    volume.intensity().bindUnit(0);
    volume.radiation().bindUnit(1);
    volume.segmentation().bindUnit(2);
    volume.shownLabels().bindUnit(3);
    volume.cells().skipMap(visible).bindUnit(4);
    volume.cells().ranges().bindUnit(5);
    m_transfer.texture().bindUnit(6);
    palette.texture().bindUnit(7);
    active.set("voxelTrue", palette.voxelTrue()).set("bodiless", unsigned(scene.bodiless));
    if (contextVariant(scene) == 1) {
        m_segmentCells.distances(volume).bindUnit(28);
        active.set("contextOpacity", contextOpacity(scene));
    }
    volume.maximumCells().texture().bindUnit(8);
    active.use();
}

void RaycastPass::setRays(Program& program, const VolumeTextures& volume, const VolumeScene& scene,
    const ViewFrame& view, const PassTarget& target)
{
    const glm::dmat4 worldToIndex = volume.geometry().worldToIndex();
    const glm::dvec3 voxel = 1.0 / glm::dvec3(volume.size());
    const glm::dmat3 indexToTexture(
        glm::dvec3(voxel.x, 0, 0), glm::dvec3(0, voxel.y, 0), glm::dvec3(0, 0, voxel.z));
    const glm::dmat3 worldToTexture = indexToTexture * glm::dmat3(worldToIndex);
    const auto toTexture = [&](const glm::dvec3& lps) {
        return (glm::dvec3(worldToIndex * glm::dvec4(lps, 1.0)) + 0.5) * voxel;
    };
    const glm::dvec2& middle = view.middle;
    const glm::dvec3 perX = worldToTexture * (view.right * view.mmPerPixel);
    const glm::dvec3 perY = worldToTexture * (view.down * view.mmPerPixel);
    const glm::dvec3 forward = worldToTexture * view.forward;

    glm::dvec3 originBase = toTexture(view.eyeLps);
    glm::dvec3 originPerX{0.0};
    glm::dvec3 originPerY{0.0};
    glm::dvec3 directionBase = worldToTexture * view.sight;
    glm::dvec3 directionPerX{0.0};
    glm::dvec3 directionPerY{0.0};
    double planePerPixel = 0.0;
    double nearest = 0.0;
    if (scene.orthographic) {
        originBase = toTexture(scene.targetLps) - perX * middle.x - perY * middle.y;
        originPerX = perX;
        originPerY = perY;
        nearest = -1e6; // the whole volume, wherever the eye is said to be
    } else {
        directionPerX = perX / view.distanceMm;
        directionPerY = perY / view.distanceMm;
        directionBase = forward - directionPerX * view.ahead.x - directionPerY * view.ahead.y;
        planePerPixel = view.mmPerPixel / view.distanceMm;
    }
    const glm::dvec3 up = -view.down;
    const glm::dvec3 toLight = glm::normalize(-view.forward * 0.80 + up * 0.48 - view.right * 0.36);
    // The golden ratio spreads the phases of any number of pictures evenly.
    const double phase = std::fmod(target.sample * 0.6180339887498949, 1.0);
    program.set("originBase", glm::vec3(originBase))
        .set("originPerX", glm::vec3(originPerX))
        .set("originPerY", glm::vec3(originPerY))
        .set("directionBase", glm::vec3(directionBase))
        .set("directionPerX", glm::vec3(directionPerX))
        .set("directionPerY", glm::vec3(directionPerY))
        .set("planeCentre", glm::vec2(view.ahead))
        .set("planePerPixel", float(planePerPixel))
        .set("nearest", float(nearest))
        .set("stepMm", float(stepMm(scene, volume.geometry(), m_voxelTrue)))
        .set("jitterPhase", float(phase))
        .set("pixelScale", target.pixelScale)
        .set("pixelJitter", target.pixelJitter)
        .set("voxel", glm::vec3(voxel))
        .set("gradientToWorld", glm::mat3(glm::transpose(glm::dmat3(worldToIndex))))
        .set("worldToTexture", glm::mat3(worldToTexture))
        .set("textureToWorld", glm::mat3(glm::inverse(worldToTexture)))
        .set("toLight", glm::vec3(toLight))
        .set("viewUp", glm::vec3(up))
        .set("aoTilt", target.sample == 0 ? 0.0f : 0.9f);
}

void RaycastPass::setClip(
    Program& program, const VolumeTextures& volume, const core::ClipRegion& clip)
{
    const core::VolumeGeometry& geometry = volume.geometry();
    const glm::dvec3 size(volume.size());
    glm::dvec3 low(0.0);
    glm::dvec3 high(1.0);
    if (clip.box.on) {
        low = glm::clamp((clip.box.minimum + 0.5) / size, 0.0, 1.0);
        high = glm::clamp((clip.box.maximum + 0.5) / size, low, glm::dvec3(1.0));
    }
    std::array<glm::vec4, 3> planes;
    std::array<glm::vec4, 3> normals;
    static_assert(std::tuple_size_v<decltype(clip.planes)> == planes.size());
    for (std::size_t i = 0; i < planes.size(); ++i) {
        planes[i] = {0.0f, 0.0f, 0.0f, 1.0f}; // keeps all
        normals[i] = glm::vec4(glm::vec3(clip.planes[i].normalLps), 0.0f);
        core::ClipRegion alone;
        alone.planes[i] = clip.planes[i];
        for (const core::HalfSpace& half : core::halfSpaces(alone, geometry)) {
            // texture = (index + 0.5) / size
            planes[i] = glm::vec4(half.normal * size,
                half.offset + 0.5 * (half.normal.x + half.normal.y + half.normal.z));
        }
    }
    program.set("clipLow", glm::vec3(low))
        .set("clipHigh", glm::vec3(high))
        .set("clipPlanes", std::span<const glm::vec4>(planes))
        .set("clipNormals", std::span<const glm::vec4>(normals));
}

/// What surface and volume rendering need for cut faces.
void RaycastPass::setFaces(Program& program, const VolumeTextures& volume, const VolumeScene& scene)
{
    const core::VoxelEncoding& encoding = volume.encoding();
    program.set("lookup", glm::vec2(m_transfer.entryOfTexel(encoding)))
        .set("greyFaces", scene.cutFaces == CutFaces::GreyValues ? 1.0f : 0.0f)
        .set("faceWindow", glm::vec2(greyOfTexel(encoding, scene.faceWindow)));
}

VisibleCodes RaycastPass::setMode(
    Program& program, VolumeTextures& volume, const VolumeScene& scene)
{
    constexpr int lastCode = core::VoxelEncoding::codeCount - 1;
    const core::VoxelEncoding& encoding = volume.encoding();
    switch (scene.mode) {
    case RenderMode::Surface: {
        if (scene.context == Context::Hidden) {
            program.set("threshold", 2.0f).set("denseSpan", 1.0f).set("aoRadius", 14.0f);
            setFaces(program, volume, scene);
            return {}; // no code is
        }
        const int code = encoding.lowestCodeAtLeast(scene.surfaceThreshold);
        const double solid = std::max((volume.cells().greatestCode() - code) * 0.35, 4.0);
        program.set("threshold", float(code / 65535.0))
            .set("denseSpan", float(solid / 65535.0))
            .set("aoRadius", 14.0f);
        m_transfer.set(scene.transferFunction.points.empty()
                ? materialColours(scene.surfaceThreshold,
                    scene.surfaceThreshold + solid * valueOfTexel(encoding).x / 65535.0)
                : scene.transferFunction,
            stepMm(scene, volume.geometry(), m_voxelTrue));
        setFaces(program, volume, scene);
        return {{{code, lastCode}}};
    }
    case RenderMode::Dvr: {
        m_transfer.set(scene.transferFunction, stepMm(scene, volume.geometry(), m_voxelTrue));
        setFaces(program, volume, scene);
        const glm::dvec2 value = valueOfTexel(encoding);
        program.set("gradientFull", float(0.08 * m_transfer.span() / value.x));
        return TransferLookup::visibleCodes(scene.transferFunction, encoding);
    }
    case RenderMode::Mip: {
        const glm::dvec2 grey = greyOfTexel(encoding, scene.mipWindow);
        std::array<float, MaximumCells::levelCount> levels{};
        for (std::size_t k = 0; k < levels.size(); ++k)
            levels[k] = float(volume.maximumCells().levels()[k] / 65535.0);
        m_colours.bind(program, scene.mipColours);
        program.set("window", glm::vec2(grey))
            .set("saturated", float((1.0 - grey.y) / grey.x))
            .set("black", float(-grey.y / grey.x))
            .set("levels", std::span<const float>(levels));
        // What is black anyway need not be looked at.
        const double black = -grey.y / grey.x * 65535.0;
        return {{{int(std::clamp(std::floor(black), 0.0, double(lastCode))), lastCode}}};
    }
    case RenderMode::Xray:
        program.set("window", glm::vec2(greyOfTexel(encoding, scene.xrayWindow)));
        return {{{0, lastCode}}}; // all that is not carved away counts
    }
    return {};
}

} // namespace gpu
