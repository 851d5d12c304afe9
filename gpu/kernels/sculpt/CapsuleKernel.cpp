// SPDX-License-Identifier: Apache-2.0
#include "gpu/kernels/sculpt/CapsuleKernel.h"

#include "gpu/fields/bricks/HiddenBricks.h"
#include "gpu/kernels/cut/ProtectedVoxels.h"
#include "gpu/kernels/work/JoinPieces.h"

#include <algorithm>
#include <map>
#include <span>
#include <utility>

namespace gpu {

namespace {

constexpr std::uint32_t changedLabel = 1; // capsulePaint.comp
constexpr std::uint32_t changedWord = 2;
constexpr std::uint32_t changedOverwritten = 4;
constexpr std::size_t piecesAtOnce = 32;
constexpr std::size_t bricksAtOnce = 1024; // storage blocks end at 128 MiB

struct GpuCapsule {
    glm::ivec4 fromLength{0};
    glm::ivec4 direction{0};
};
struct GpuCandidate {
    glm::ivec4 base{0};
    glm::uvec4 span{0};
};

Program program(const ShaderLibrary& library, const char* path, const ShaderDefines& defines = {})
{
    return Program(library, ComputeProgramOptions{.label = path, .path = path, .defines = defines});
}

/// Bricks that were given a page for the stroke and do not need it.
void releaseUnused(BrickField& field, const std::vector<std::uint32_t>& fresh,
    const std::vector<std::uint32_t>& changed)
{
    std::vector<std::uint32_t> unused;
    std::set_difference(
        fresh.begin(), fresh.end(), changed.begin(), changed.end(), std::back_inserter(unused));
    field.release(unused);
}

std::vector<std::uint32_t> withoutPage(
    const BrickField& field, const std::vector<std::uint32_t>& bricks)
{
    std::vector<std::uint32_t> fresh;
    for (const std::uint32_t brick : bricks) {
        if (!field.holds(brick))
            fresh.push_back(brick);
    }
    return fresh;
}

} // namespace

CapsulePrograms::CapsulePrograms(const ShaderLibrary& library)
    : barrier(program(library, "kernels/sculpt/capsuleBarrier.comp"))
    , cut(program(library, "kernels/sculpt/capsuleCut.comp"))
    , m_library(library)
    , m_editable(library)
{
    m_paint[0] = program(library, "kernels/sculpt/capsulePaint.comp");
}

Program& CapsulePrograms::givingBarrier()
{
    if (!m_givingBarrier)
        m_givingBarrier =
            program(m_library, "kernels/sculpt/capsuleBarrier.comp", {{"OVERWRITTEN", 1}});
    return m_givingBarrier;
}

Program& CapsulePrograms::alike()
{
    if (!m_alike)
        m_alike = program(m_library, "kernels/sculpt/capsuleAlike.comp");
    return m_alike;
}

Program& CapsulePrograms::paint(bool members, bool editable)
{
    Program& painting = m_paint.at((members ? 1u : 0u) + (editable ? 2u : 0u));
    if (!painting) {
        ShaderDefines defines;
        if (members)
            defines.push_back({"MEMBERS", 1});
        if (editable)
            defines.push_back({"EDITABLE", 1});
        painting = program(m_library, "kernels/sculpt/capsulePaint.comp", defines);
    }
    return painting;
}

CapsuleKernel::CapsuleKernel(CapsulePrograms& programs, VoxelFields& fields, BeforeImages& before,
    const core::PaintLabel& paint)
    : m_programs(programs)
    , m_fields(fields)
    , m_before(before)
    , m_edit(paint)
    , m_frame(paint.frame)
{
    Program& program = painting(paint);
    setFrame(program);
    const bool none = paint.lowCode > paint.highCode || paint.highCode < 0;
    program.set("label", unsigned(paint.label))
        .set("overwritable", paint.overwritable)
        .set("erase", paint.erase)
        .set("seeds", paint.seeds)
        .set("lowCode", none ? 65536u : unsigned(std::max(paint.lowCode, 0)))
        .set("highCode", none ? 0u : unsigned(paint.highCode));
    if (!paint.edges)
        return;
    m_edges.emplace(m_frame, m_fields.grid());
    setFrame(m_programs.alike());
    setEdges(paint);
}

CapsuleKernel::CapsuleKernel(CapsulePrograms& programs, VoxelFields& fields, BeforeImages& before,
    const core::PaintBarrier& barrier)
    : m_programs(programs)
    , m_givesBack(!barrier.erase && fields.anyOverwritten(barrier.plane))
    , m_fields(fields)
    , m_before(before)
    , m_edit(barrier)
    , m_frame(barrier.frame)
{
    Program& barrierProgram = m_givesBack ? m_programs.givingBarrier() : m_programs.barrier;
    setFrame(barrierProgram);
    barrierProgram.set("erase", barrier.erase).set("lockedLabels", barrier.lockedLabels);
}

CapsuleKernel::CapsuleKernel(CapsulePrograms& programs, VoxelFields& fields, BeforeImages& before,
    const core::CapsuleCut& cut)
    : m_programs(programs)
    , m_fields(fields)
    , m_before(before)
    , m_edit(cut)
    , m_frame(cut.frame)
{
    setFrame(m_programs.cut);
    m_programs.cut.set("rampHalfWidth", m_frame.rampHalfWidth).set("refill", cut.restore);
    setHidden(m_programs.cut, cut.hidden);
    setProtected(m_programs.cut, m_fields, cut.protectedLabels);
}

void CapsuleKernel::setFrame(Program& each) const
{
    each.set("volumeSize", m_fields.grid().volumeSize)
        .set("volumeBricks", m_fields.grid().bricks())
        .set("perI", core::strokeStep(m_frame.perI))
        .set("perJ", core::strokeStep(m_frame.perJ))
        .set("perK", core::strokeStep(m_frame.perK))
        .set("isFlat", m_frame.isFlat)
        .set("isSquare", m_frame.isSquare)
        .set("halfThickness", m_frame.halfThickness)
        .set("radius", m_frame.radius)
        .set("reach", m_frame.reach)
        .set("shift", m_frame.shift);
}

Program& CapsuleKernel::painting(const core::PaintLabel& paint) const
{
    return m_programs.paint(paint.edges.has_value(), paint.editable.has_value());
}

core::Result<void> CapsuleKernel::extend(const core::EngineExtension& extension)
{
    const auto* path = std::get_if<core::CapsulePath>(&extension);
    if (!path)
        return EditWork::extend(extension);
    if (m_edges)
        followEdges(*path);
    else
        follow(path->capsules);
    return {};
}

bool CapsuleKernel::join(core::EngineExtension& earlier, core::EngineExtension& next) const
{
    return joinPieces(earlier, next, &core::CapsulePath::capsules)
        && joinPieces(earlier, next, &core::CapsulePath::under);
}

void CapsuleKernel::follow(const std::vector<core::Capsule>& capsules)
{
    // Neither the order nor the company of pieces matters, so a long path comes in parts.
    for (std::size_t first = 0; first < capsules.size(); first += piecesAtOnce) {
        const std::size_t last = std::min(first + piecesAtOnce, capsules.size());
        extendBy(
            {capsules.begin() + std::ptrdiff_t(first), capsules.begin() + std::ptrdiff_t(last)});
    }
}

void CapsuleKernel::extendBy(const std::vector<core::Capsule>& capsules)
{
    const auto writeTo = [&](const Candidates& candidates) {
        std::visit([&](const auto& edit) { write(edit, candidates, capsules); }, m_edit);
    };
    std::map<std::uint32_t, std::vector<std::uint32_t>> near;
    for (std::uint32_t number = 0; number < capsules.size(); ++number) {
        for (const std::uint32_t brick :
            core::bricksNear(m_frame, capsules[number], m_fields.grid()))
            near[brick].push_back(number);
    }
    Candidates batch;
    for (auto& [brick, numbers] : near) {
        // Voxels are joined through bricks that hold nothing, too.
        if (!m_edges && nothingToTakeAway(brick))
            continue;
        batch.bricks.push_back(brick);
        batch.near.push_back(std::move(numbers));
        if (batch.bricks.size() == bricksAtOnce)
            writeTo(std::exchange(batch, {}));
    }
    if (!batch.bricks.empty())
        writeTo(batch);
}

bool CapsuleKernel::nothingToTakeAway(std::uint32_t brick) const
{
    return std::visit([&](const auto& edit) { return nothingFor(edit, brick); }, m_edit);
}

bool CapsuleKernel::nothingFor(const core::PaintLabel& paint, std::uint32_t brick) const
{
    return paint.erase && !has(core::Field::Labels, paint.plane, brick)
        && !has(core::Field::SeedWords, paint.plane, brick);
}

bool CapsuleKernel::nothingFor(const core::PaintBarrier& barrier, std::uint32_t brick) const
{
    return barrier.erase && !has(core::Field::SeedWords, barrier.plane, brick);
}

bool CapsuleKernel::nothingFor(const core::CapsuleCut& cut, std::uint32_t brick) const
{
    return cut.restore && !has(core::Field::Coverage, cut.layer, brick);
}

bool CapsuleKernel::has(core::Field field, std::uint8_t plane, std::uint32_t brick) const
{
    return m_fields.hasData({.field = field, .plane = plane, .brick = brick});
}

std::vector<std::uint32_t> CapsuleKernel::run(
    Program& each, const Candidates& candidates, const std::vector<core::Capsule>& capsules)
{
    std::vector<GpuCandidate> bases;
    std::vector<std::uint32_t> near;
    for (std::size_t i = 0; i < candidates.bricks.size(); ++i) {
        const std::uint32_t brick = candidates.bricks[i];
        const auto first = unsigned(near.size());
        near.insert(near.end(), candidates.near[i].begin(), candidates.near[i].end());
        bases.push_back(
            {glm::ivec4(
                 core::strokeBase(m_frame, m_fields.grid().boxOf(int(brick)).minimum), int(brick)),
                glm::uvec4(first, near.size(), 0, 0)});
    }
    std::vector<GpuCapsule> pieces;
    for (const core::Capsule& capsule : capsules)
        pieces.push_back({glm::ivec4(capsule.from, capsule.length),
            glm::ivec4(capsule.direction,
                int(std::uint32_t(capsule.less) | std::uint32_t(capsule.strength) << 24U))});

    const Buffer baseBuffer = bufferOf("brush candidates", bases);
    const Buffer pieceBuffer = bufferOf("brush path", pieces);
    const Buffer nearBuffer = bufferOf("brush pieces near", near);
    std::vector<std::uint32_t> changed(candidates.bricks.size(), 0);
    const Buffer changedBuffer = bufferOf("brush changed", changed);
    baseBuffer.bindBase(GL_SHADER_STORAGE_BUFFER, 0);
    pieceBuffer.bindBase(GL_SHADER_STORAGE_BUFFER, 1);
    nearBuffer.bindBase(GL_SHADER_STORAGE_BUFFER, 2);
    changedBuffer.bindBase(GL_SHADER_STORAGE_BUFFER, 3);
    each.dispatch({unsigned(candidates.bricks.size()), 1, 1});
    glMemoryBarrier(GL_ALL_BARRIER_BITS);
    changedBuffer.read(std::span<std::uint32_t>(changed));
    return changed;
}

void CapsuleKernel::write(const core::PaintLabel& paint, const Candidates& candidates,
    const std::vector<core::Capsule>& capsules)
{
    if (m_edges)
        findAlike(candidates, capsules);
    else
        writeLabels(
            painting(paint), paint.plane, paint.seeds && !paint.erase, candidates, capsules);
}

void CapsuleKernel::write(const core::PaintBarrier& barrier, const Candidates& candidates,
    const std::vector<core::Capsule>& capsules)
{
    Program& barrierProgram = m_givesBack ? m_programs.givingBarrier() : m_programs.barrier;
    if (m_givesBack) {
        BrickField& overwritten = m_fields.overwritten(barrier.plane);
        m_before.capture(core::Field::Overwritten, barrier.plane, candidates.bricks);
        overwritten.pageTable().bindUnit(2);
        overwritten.atlas().bindImage(2, GL_READ_WRITE);
    }
    writeLabels(barrierProgram, barrier.plane, !barrier.erase, candidates, capsules);
}

void CapsuleKernel::writeLabels(Program& program, std::uint8_t plane, bool newWords,
    const Candidates& candidates, const std::vector<core::Capsule>& capsules)
{
    BrickField& seedWords = m_fields.seedWords(plane);
    m_before.capture(core::Field::Labels, plane, candidates.bricks);
    m_before.capture(core::Field::SeedWords, plane, candidates.bricks);
    std::vector<std::uint32_t> fresh;
    if (newWords) {
        fresh = withoutPage(seedWords, candidates.bricks);
        seedWords.ensure(fresh);
    }
    Buffer editable;
    const auto* paint = std::get_if<core::PaintLabel>(&m_edit);
    if (paint && paint->editable) {
        editable = m_programs.editable().find(*paint->editable, m_fields, candidates.bricks);
        editable.bindBase(GL_SHADER_STORAGE_BUFFER, EditableBits::binding);
    }
    m_fields.codes().bindUnit(0);
    seedWords.pageTable().bindUnit(1);
    m_fields.labels(plane).bindImage(0, GL_READ_WRITE);
    seedWords.atlas().bindImage(1, GL_READ_WRITE);
    const std::vector<std::uint32_t> found = run(program, candidates, capsules);

    std::vector<std::uint32_t> labels;
    std::vector<std::uint32_t> words;
    for (std::size_t i = 0; i < found.size(); ++i) {
        const std::uint32_t brick = candidates.bricks[i];
        if ((found[i] & changedLabel) != 0) {
            labels.push_back(brick);
            m_touched.insert({core::Field::Labels, plane, brick});
        }
        if ((found[i] & changedWord) != 0) {
            words.push_back(brick);
            m_touched.insert({core::Field::SeedWords, plane, brick});
        }
        if ((found[i] & changedOverwritten) != 0)
            m_touched.insert({core::Field::Overwritten, plane, brick});
    }
    releaseUnused(seedWords, fresh, words);
    m_fields.noteChanged(core::Field::Labels, labels);
    m_fields.noteChanged(core::Field::SeedWords, words);
}

void CapsuleKernel::write(const core::CapsuleCut& cut, const Candidates& candidates,
    const std::vector<core::Capsule>& capsules)
{
    BrickField& coverage = m_fields.coverage(cut.layer);
    m_before.capture(core::Field::Coverage, cut.layer, candidates.bricks);
    const std::vector<std::uint32_t> fresh = withoutPage(coverage, candidates.bricks);
    coverage.ensure(fresh);
    coverage.pageTable().bindUnit(1);
    coverage.atlas().bindImage(0, GL_READ_WRITE);
    bindProtected(m_fields, cut.protectedLabels);
    const Buffer hidden = hiddenBases(cut.hidden, m_fields.grid(), candidates.bricks);
    hidden.bindBase(GL_SHADER_STORAGE_BUFFER, 6);
    const bool pressed = std::any_of(capsules.begin(), capsules.end(),
        [](const core::Capsule& capsule) { return capsule.less != 0; });
    m_programs.cut.set("pressed", pressed);
    const std::vector<std::uint32_t> found = run(m_programs.cut, candidates, capsules);

    std::vector<std::uint32_t> changed;
    for (std::size_t i = 0; i < found.size(); ++i) {
        if (found[i] == 0)
            continue;
        changed.push_back(candidates.bricks[i]);
        m_touched.insert({core::Field::Coverage, cut.layer, candidates.bricks[i]});
    }
    releaseUnused(coverage, fresh, changed);
    m_fields.noteChanged(core::Field::Coverage, changed);
}

std::vector<core::BrickKey> CapsuleKernel::touchedKeys() const
{
    return {m_touched.begin(), m_touched.end()};
}

} // namespace gpu
