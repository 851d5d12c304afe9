// SPDX-License-Identifier: Apache-2.0
#include "gpu/engine/KernelWarmUp.h"

#include "core/edits/document/DocumentEdits.h"
#include "core/edits/engine/EngineEdits.h"
#include "core/edits/kinds/filling/SegmentScissors.h"
#include "core/edits/kinds/growth/BarrierStroke.h"
#include "core/edits/kinds/parts/BrushPath.h"
#include "core/edits/kinds/parts/PenSample.h"
#include "core/edits/kinds/sculpt/BrushStroke.h"
#include "core/edits/kinds/sculpt/DrillPathSampler.h"
#include "core/edits/kinds/sculpt/DrillStroke.h"
#include "core/edits/kinds/sculpt/LaserStroke.h"
#include "core/edits/kinds/sculpt/PeelCut.h"
#include "core/edits/kinds/sculpt/ScissorsCut.h"
#include "core/edits/kinds/segments/PaintStroke.h"
#include "core/growth/SeedWord.h"
#include "gpu/gl/GlFailure.h"

#include <array>
#include <bit>
#include <span>

namespace gpu {

namespace {

constexpr int leastSide = 32; // voxels of 1 mm
constexpr std::uint16_t matter = 1000;
constexpr std::uint8_t label = 1;

/// A box of matter in air.
std::vector<std::uint16_t> someCodes(const glm::ivec3& size)
{
    std::vector<std::uint16_t> codes;
    for (int k = 0; k < size.z; ++k)
        for (int j = 0; j < size.y; ++j)
            for (int i = 0; i < size.x; ++i) {
                const glm::ivec3 voxel(i, j, k);
                const bool inside = glm::all(glm::greaterThan(voxel, glm::ivec3(3)))
                    && glm::all(glm::lessThan(voxel, size - 4));
                codes.push_back(inside ? matter : 0);
            }
    return codes;
}

core::OrthographicView fromFront()
{
    const double middle = leastSide / 2.0;
    return {.eyeLps = {middle, -100.0, middle}, .targetLps = glm::dvec3(middle), .up = {0, 0, 1}};
}

const std::vector<glm::dvec2> outline{{-6, -6}, {6, -6}, {6, 6}, {-6, 6}};
const std::vector<core::PenSample> path{{.xMm = -3.0}, {.xMm = 3.0, .tSeconds = 0.1}};
/// Both kernels of ranges are needed for it: that of values and that of labels.
core::EditableVoxels limits()
{
    core::EditableVoxels editable{.lowCode = 0, .highCode = matter};
    editable.outside.push_back({.plane = 0});
    editable.outside.back().labels.set(label + 1);
    return editable;
}

const core::BrushPath brushPath{.radiusMm = 3.0, .pointsLps = {{16, 6, 16}, {16, 12, 16}}};

} // namespace

glm::ivec3 KernelWarmUp::sizeLike(const glm::ivec3& volumeSize)
{
    glm::ivec3 size;
    for (int axis = 0; axis < 3; ++axis) {
        const auto voxels = unsigned(volumeSize[axis]);
        const unsigned bricks = (voxels + core::BrickGrid::side - 1) / core::BrickGrid::side;
        size[axis] = std::has_single_bit(voxels) ? leastSide
            : std::has_single_bit(bricks)        ? 50
                                                 : 40;
    }
    return size;
}

KernelWarmUp::KernelWarmUp(
    EditPrograms& programs, FieldPrograms& fieldPrograms, const glm::ivec3& size, Of kernels)
    : m_programs(programs)
    , m_kernels(kernels)
{
    const std::vector<std::uint16_t> codes = someCodes(size);
    if (!m_textures.open(size, codes))
        return; // no room for it: the tools will do without
    m_fields = std::make_unique<VoxelFields>(fieldPrograms, m_textures);
    core::Volume volume;
    volume.geometry.size = size;
    m_document = core::initialDocument(std::move(volume));
    core::Segment segment;
    segment.label = label;
    m_document.segments.push_back(segment);
    std::bitset<256> shown;
    shown.set(label);
    m_fields->setShownLabels(shown);
}

bool KernelWarmUp::runNext()
{
    static constexpr std::array tools{&KernelWarmUp::runDrill, &KernelWarmUp::runBrushes,
        &KernelWarmUp::runTakingGrowth, &KernelWarmUp::runGrowth, &KernelWarmUp::runLaser,
        &KernelWarmUp::runPeel, &KernelWarmUp::runScissors, &KernelWarmUp::runTolerance,
        &KernelWarmUp::runRelabelling, &KernelWarmUp::runBarriers};
    static constexpr std::array within{
        &KernelWarmUp::runPaintWithin, &KernelWarmUp::runRelabellingWithin};
    const std::span<void (KernelWarmUp::*const)()> runs = m_kernels == Of::AllTools
        ? std::span<void (KernelWarmUp::*const)()>(tools)
        : std::span<void (KernelWarmUp::*const)()>(within);
    if (!m_fields || m_done == runs.size())
        return false;
    (this->*runs[m_done++])();
    m_fields->updateSegmentation(std::size_t(m_fields->grid().brickCount()));
    return m_done < runs.size();
}

void KernelWarmUp::run(const core::EngineEdit& edit,
    const std::vector<core::EngineExtension>& extensions, core::Ending ending)
{
    auto transaction = EditTransaction::begin(m_programs, *m_fields, edit);
    if (!transaction)
        return;
    for (const core::EngineExtension& extension : extensions) {
        if (!(*transaction)->extend(extension))
            break;
    }
    while ((*transaction)->hasStepsLeft()) {
        (*transaction)->advance(GrowthKernel::ringsPerBatch);
        requireNoError(); // in a lost context it would go on for ever
    }
    core::EngineResult result;
    if (ending == core::Ending::Commit)
        (*transaction)->commit(result);
    else
        (*transaction)->rollBack(result);
}

void KernelWarmUp::runDrill()
{
    core::DrillStroke stroke{.view = fromFront()};
    stroke.mask.radiusMm = 3.0;
    stroke.surfaceThreshold = matter;
    stroke.samples = path;
    // One that cuts stays, so that the later tools meet what is carved.
    for (const bool restore : {false, true}) {
        stroke.restore = restore;
        if (const auto cut = core::drillCut(stroke, m_document))
            run(*cut, {core::DrillPath{core::drillPath(stroke, *cut)}},
                restore ? core::Ending::Rollback : core::Ending::Commit);
    }
}

void KernelWarmUp::runLaser()
{
    core::LaserStroke stroke{.view = fromFront()};
    stroke.mask.radiusMm = 3.0;
    stroke.surfaceThreshold = matter;
    stroke.samples = path;
    if (const auto cut = core::laserCut(stroke, m_document))
        run(*cut, {core::DrillPath{core::laserPath(stroke, *cut)}});
}

void KernelWarmUp::runPeel()
{
    core::PeelCut peel{.view = fromFront(), .polygonMm = outline};
    peel.surfaceThreshold = matter;
    if (const auto cut = core::shellPeel(peel, m_document))
        run(*cut, {core::peelDepth(peel)});
}

void KernelWarmUp::runScissors()
{
    core::ScissorsCut scissors{.view = fromFront(), .polygonMm = outline};
    if (const auto cut = core::outlineCut(scissors, m_document))
        run(*cut, {});
}

void KernelWarmUp::runBrushes()
{
    const core::CapsulePath capsules{
        core::capsules(brushPath, m_document.volumes.front().geometry)};
    runPaint(std::nullopt);
    if (const auto barrier = core::paintBarrier({.path = brushPath}, m_document))
        run(*barrier, {capsules});
    if (const auto carve = core::capsuleCut({.path = brushPath}, m_document))
        run(*carve, {capsules});
}

void KernelWarmUp::runPaint(const std::optional<core::EditableVoxels>& editable)
{
    core::PaintStroke stroke{.segment = label, .path = brushPath};
    for (const std::optional<double> tolerance : {std::optional<double>(), std::optional(1.0)}) {
        stroke.edgeTolerance = tolerance;
        auto paint = core::paintLabel(stroke, m_document);
        if (!paint)
            continue;
        paint->editable = editable;
        run(*paint, {core::paintPath(stroke, m_document.volumes.front().geometry)});
    }
}

void KernelWarmUp::runTakingGrowth()
{
    // One that may take voxels from others keeps what it overwrites, by kernels of its own.
    run(core::SeedPlacement{.label = label, .voxels = {glm::ivec3(leastSide / 2)}}, {},
        core::Ending::Commit);
    core::GrowBurst burst{.lowCode = matter, .highCode = matter};
    burst.overwritable.set(label + 1);
    run(burst, {core::GrowAdvance{}});
}

void KernelWarmUp::runGrowth()
{
    // From one seed the front is small first and then large: both forms of the kernel run.
    run(core::SeedPlacement{.label = label, .voxels = {glm::ivec3(leastSide / 2)}}, {},
        core::Ending::Commit);
    core::GrowBurst burst{.lowCode = matter, .highCode = matter};
    run(burst, {core::GrowAdvance{}}, core::Ending::Commit);
    burst.generation = core::seedWord::maxGeneration;
    burst.opening = core::GrowOpening::Narrow;
    run(burst, {});
    run(core::ShrinkGrowth{.generation = core::seedWord::maxGeneration, .keep = 2}, {});
}

void KernelWarmUp::runTolerance()
{
    // What has grown stands on its seed.
    auto kernel = ToleranceKernel::begin(
        m_programs.tolerance, *m_fields, {.plane = 0, .label = label, .connectivity = 6});
    while (kernel && !(*kernel)->done()) {
        (*kernel)->advance(std::size_t(m_fields->grid().brickCount()));
        requireNoError();
    }
    m_fields->dropTolerance();
}

void KernelWarmUp::runRelabelling()
{
    relabel(std::nullopt);
}

void KernelWarmUp::runPaintWithin()
{
    runPaint(limits());
}

void KernelWarmUp::runRelabellingWithin()
{
    relabel(limits());
}

void KernelWarmUp::relabel(const std::optional<core::EditableVoxels>& editable)
{
    // A click on a chunk.
    core::RelabelListed listed{.target = {.plane = 0, .label = label}, .bricks = {}};
    listed.bricks.push_back({.brick = 0,
        .asked =
            std::vector<std::uint8_t>(core::BrickGrid::voxelsPerBrick, core::RelabelListed::give)});
    listed.editable = editable;
    run(listed, {});
    // An outline on a slice.
    core::LabelOutlined outlined{.target = listed.target};
    outlined.perI[0] = outlined.perJ[1] = outlined.perK[2] = std::int64_t(1) << 30;
    outlined.corners = {{0, 0}, {2 << 16, 0}, {0, 2 << 16}};
    outlined.editable = editable;
    run(outlined, {});
    // An interval of values that follows a slider.
    core::LabelThreshold threshold{.target = listed.target, .lowCode = matter};
    threshold.editable = editable;
    run(threshold, {});
    // Scissors of segments, with their rays.
    core::SegmentScissors scissors{.segment = label, .view = fromFront(), .polygonMm = outline};
    scissors.depthMm = 2.0;
    if (auto snip = core::labelScissors(scissors, m_document)) {
        snip->editable = editable;
        run(*snip, {});
    }
}

void KernelWarmUp::runBarriers()
{
    // A surface that becomes a barrier.
    core::BarrierListed listed;
    listed.bricks.push_back({.brick = 0});
    listed.bricks.back().places.set();
    run(listed, {});
}

} // namespace gpu
