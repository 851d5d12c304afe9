// SPDX-License-Identifier: Apache-2.0
#include "gpu/kernels/labels/LabelKernel.h"

#include "core/sculpt/labels/LabelOutlined.h"
#include "gpu/fields/bricks/HiddenBricks.h"
#include "gpu/kernels/labels/ChosenBricks.h"

#include <algorithm>
#include <iterator>
#include <numeric>

namespace gpu {

namespace {

constexpr std::uint32_t changesLabel = 1; // chooseLabel.comp
constexpr std::uint32_t changesWord = 2;
constexpr std::size_t labelBricksAtOnce = 1024; // storage blocks end at 128 MiB

/// Runs a kernel whose textures are bound over bricks. @return what it says of each
std::vector<std::uint32_t> runOver(
    Program& kernel, const std::vector<std::uint32_t>& bricks, bool write)
{
    std::vector<std::uint32_t> found(bricks.size(), 0);
    const Buffer list = bufferOf("labelled bricks", bricks);
    const Buffer changed = bufferOf("labelled found", found);
    list.bindBase(GL_SHADER_STORAGE_BUFFER, 0);
    changed.bindBase(GL_SHADER_STORAGE_BUFFER, 1);
    kernel.set("write", write);
    kernel.dispatch({unsigned(bricks.size()), 1, 1});
    glMemoryBarrier(GL_ALL_BARRIER_BITS);
    changed.read(std::span<std::uint32_t>(found));
    return found;
}

/// Those of these bricks that may hold one of these codes.
std::vector<std::uint32_t> holdingCodes(
    const VoxelFields& fields, std::vector<std::uint32_t> bricks, int lowCode, int highCode)
{
    std::erase_if(
        bricks, [&](std::uint32_t brick) { return !fields.mayHold(brick, lowCode, highCode); });
    return bricks;
}

/// Those that are in both lists, which ascend.
std::vector<std::uint32_t> inBoth(
    const std::vector<std::uint32_t>& some, const std::vector<std::uint32_t>& others)
{
    std::vector<std::uint32_t> both;
    std::set_intersection(
        some.begin(), some.end(), others.begin(), others.end(), std::back_inserter(both));
    return both;
}

/// Binds which voxels of bricks may change, if not all may.
class BindEditable {
public:
    BindEditable(LabelPrograms& programs, VoxelFields& fields,
        const std::optional<core::EditableVoxels>& editable)
        : m_programs(programs)
        , m_fields(fields)
        , m_editable(editable)
    {
    }
    /// Those of these bricks, which ascend, in which any voxel may change.
    [[nodiscard]] std::vector<std::uint32_t> among(std::vector<std::uint32_t> bricks) const
    {
        if (!m_editable)
            return bricks;
        if (m_editable->inside)
            bricks = inBoth(bricks, m_fields.labelledBricks());
        if (m_editable->box)
            bricks = inBoth(bricks, core::bricksMeeting(*m_editable->box, m_fields.grid()));
        return holdingCodes(m_fields, std::move(bricks), m_editable->lowCode, m_editable->highCode);
    }
    void operator()(const std::vector<std::uint32_t>& bricks)
    {
        if (!m_editable)
            return;
        m_bits = m_programs.editable().find(*m_editable, m_fields, bricks);
        m_bits.bindBase(GL_SHADER_STORAGE_BUFFER, EditableBits::binding);
    }

private:
    LabelPrograms& m_programs;
    VoxelFields& m_fields;
    const std::optional<core::EditableVoxels>& m_editable;
    Buffer m_bits;
};

/// @param bindSource binds what voxels of these bricks are chosen by
/// @param editable binds first what they may change
template <class Bind>
std::vector<core::BrickKey> label(Program& kernel, VoxelFields& fields, BeforeImages& before,
    const core::LabelTarget& target, const std::vector<std::uint32_t>& concerned,
    const Bind& bindSource, BindEditable* editable = nullptr)
{
    const std::vector<std::uint32_t> bricks = editable ? editable->among(concerned) : concerned;
    kernel.set("volumeSize", fields.grid().volumeSize)
        .set("volumeBricks", fields.grid().bricks())
        .set("label", unsigned(target.label))
        .set("overwritable", target.overwritable);
    BrickField& seedWords = fields.seedWords(target.plane);
    const auto bind = [&](const std::vector<std::uint32_t>& listed) {
        if (editable)
            (*editable)(listed);
        bindSource(listed);
        seedWords.pageTable().bindUnit(1);
        fields.labels(target.plane).bindImage(0, GL_READ_WRITE);
        seedWords.atlas().bindImage(1, GL_READ_WRITE);
    };
    std::vector<core::BrickKey> keys;
    for (std::size_t first = 0; first < bricks.size(); first += labelBricksAtOnce) {
        const std::size_t last = std::min(first + labelBricksAtOnce, bricks.size());
        const std::vector<std::uint32_t> batch(
            bricks.begin() + std::ptrdiff_t(first), bricks.begin() + std::ptrdiff_t(last));
        bind(batch);
        const std::vector<std::uint32_t> found = runOver(kernel, batch, false);
        const std::vector<std::uint32_t> labels = chosen(batch, found, changesLabel);
        const std::vector<std::uint32_t> wordBricks = chosen(batch, found, changesWord);
        const std::vector<std::uint32_t> either = chosen(batch, found, changesLabel | changesWord);
        if (either.empty())
            continue;
        before.capture(core::Field::Labels, target.plane, labels);
        before.capture(core::Field::SeedWords, target.plane, wordBricks);
        bind(either); // capturing has bound textures of its own
        runOver(kernel, either, true);
        fields.noteChanged(core::Field::Labels, labels);
        fields.noteChanged(core::Field::SeedWords, wordBricks);
        for (const std::uint32_t brick : labels)
            keys.push_back({core::Field::Labels, target.plane, brick});
        for (const std::uint32_t brick : wordBricks)
            keys.push_back({core::Field::SeedWords, target.plane, brick});
    }
    return keys;
}

std::vector<std::uint32_t> allBricks(const VoxelFields& fields)
{
    std::vector<std::uint32_t> bricks(std::size_t(fields.grid().brickCount()));
    std::iota(bricks.begin(), bricks.end(), 0u);
    return bricks;
}

template <class Brick> std::vector<std::uint32_t> numbersOf(const std::vector<Brick>& bricks)
{
    std::vector<std::uint32_t> numbers;
    for (const Brick& brick : bricks)
        numbers.push_back(brick.brick);
    return numbers;
}

/// Binds what is asked of the voxels of listed bricks.
template <class Brick> class AskedBytes {
public:
    AskedBytes(const std::vector<Brick>& bricks, std::vector<std::uint8_t> Brick::*voxels)
        : m_bricks(bricks)
        , m_voxels(voxels)
        , m_buffer({.label = "asked voxels",
              .bytes = labelBricksAtOnce * core::BrickGrid::voxelsPerBrick})
    {
    }

    void operator()(const std::vector<std::uint32_t>& numbers) const
    {
        std::vector<std::uint8_t> bytes;
        bytes.reserve(numbers.size() * core::BrickGrid::voxelsPerBrick);
        for (const std::uint32_t number : numbers) {
            const auto brick = std::lower_bound(m_bricks.begin(), m_bricks.end(), number,
                [](const Brick& one, std::uint32_t wanted) { return one.brick < wanted; });
            bytes.insert(bytes.end(), ((*brick).*m_voxels).begin(), ((*brick).*m_voxels).end());
        }
        m_buffer.write(std::span<const std::uint8_t>(bytes));
        m_buffer.bindBase(GL_SHADER_STORAGE_BUFFER, 2);
    }

private:
    const std::vector<Brick>& m_bricks;
    std::vector<std::uint8_t> Brick::*m_voxels;
    mutable Buffer m_buffer;
};

/// Of which values voxels are chosen.
void setCodes(Program& kernel, int lowCode, int highCode)
{
    const bool none = lowCode > highCode || highCode < 0;
    kernel.set("lowCode", none ? 65536u : unsigned(std::max(lowCode, 0)))
        .set("highCode", none ? 0u : unsigned(highCode));
}

/// Binds where listed bricks lie on the plane of a view, and what is hidden of them.
class BrickPlaces {
public:
    BrickPlaces(const core::CutFrame& frame, const core::BrickGrid& grid)
        : m_frame(frame)
        , m_grid(grid)
    {
    }

    void operator()(const std::vector<std::uint32_t>& numbers) const
    {
        std::vector<glm::ivec4> bases;
        bases.reserve(numbers.size());
        for (const std::uint32_t number : numbers)
            bases.emplace_back(core::planeBase(m_frame, m_grid.boxOf(int(number)).minimum), 0);
        m_bases = bufferOf("plane bases", bases);
        m_hidden = hiddenBases(m_frame.hidden, m_grid, numbers);
        m_bases.bindBase(GL_SHADER_STORAGE_BUFFER, 2);
        m_hidden.bindBase(GL_SHADER_STORAGE_BUFFER, 6);
    }

private:
    const core::CutFrame& m_frame;
    core::BrickGrid m_grid;
    mutable Buffer m_bases;
    mutable Buffer m_hidden;
};

/// Those of these bricks in which something may be held that can be lost.
std::vector<std::uint32_t> heldAmong(
    VoxelFields& fields, std::uint8_t plane, const std::vector<std::uint32_t>& bricks)
{
    const std::vector<std::uint32_t> labelled = fields.labelledBricks();
    const std::vector<std::uint32_t> seeded = fields.seedWords(plane).heldBricks();
    std::vector<std::uint32_t> held;
    std::set_union(
        labelled.begin(), labelled.end(), seeded.begin(), seeded.end(), std::back_inserter(held));
    return inBoth(bricks, held);
}

std::vector<core::BrickKey> write(LabelPrograms& programs, VoxelFields& fields,
    BeforeImages& before, const core::LabelCarved& edit)
{
    BrickField& coverage = fields.coverage(edit.layer);
    BindEditable editable(programs, fields, edit.editable);
    return label(
        programs.following("CARVED", edit.editable.has_value()), fields, before, edit.target,
        coverage.heldBricks(),
        [&coverage](const std::vector<std::uint32_t>&) {
            coverage.atlas().bindUnit(0);
            coverage.pageTable().bindUnit(2);
        },
        &editable);
}

std::vector<core::BrickKey> write(
    LabelPrograms& programs, VoxelFields& fields, BeforeImages& before, const core::LabelSeen& edit)
{
    std::vector<glm::ivec4> bounds;
    for (const core::VoxelBound& bound : edit.bounds)
        bounds.emplace_back(bound.normal, bound.offset);
    const Buffer boundBuffer = bufferOf("bounds", bounds);
    Program& kernel = programs.following("SEEN", edit.editable.has_value());
    BindEditable editable(programs, fields, edit.editable);
    setCodes(kernel, edit.lowCode, edit.highCode);
    kernel.set("boundCount", unsigned(bounds.size()));
    return label(
        kernel, fields, before, edit.target,
        holdingCodes(fields, allBricks(fields), edit.lowCode, edit.highCode),
        [&](const std::vector<std::uint32_t>&) {
            fields.codes().bindUnit(0);
            fields.radiation().bindUnit(2);
            boundBuffer.bindBase(GL_SHADER_STORAGE_BUFFER, 2);
        },
        &editable);
}

std::vector<core::BrickKey> write(LabelPrograms& programs, VoxelFields& fields,
    BeforeImages& before, const core::LabelListed& edit)
{
    const core::LabelTarget target{
        .plane = edit.plane, .label = 0, .overwritable = edit.overwritable};
    Program& kernel = programs.following("LISTED", edit.editable.has_value());
    BindEditable editable(programs, fields, edit.editable);
    kernel.set("frees", unsigned(edit.frees));
    return label(kernel, fields, before, target, numbersOf(edit.bricks),
        AskedBytes(edit.bricks, &core::LabelListed::Brick::labels), &editable);
}

std::vector<core::BrickKey> write(LabelPrograms& programs, VoxelFields& fields,
    BeforeImages& before, const core::LabelPlanes& edit)
{
    std::vector<core::BrickKey> keys;
    for (const core::LabelListed& plane : edit.planes) {
        const std::vector<core::BrickKey> its = write(programs, fields, before, plane);
        keys.insert(keys.end(), its.begin(), its.end());
    }
    return keys;
}

std::vector<core::BrickKey> write(LabelPrograms& programs, VoxelFields& fields,
    BeforeImages& before, const core::RelabelListed& edit)
{
    BindEditable editable(programs, fields, edit.editable);
    return label(programs.following("RELABELLED", edit.editable.has_value()), fields, before,
        edit.target, numbersOf(edit.bricks),
        AskedBytes(edit.bricks, &core::RelabelListed::Brick::asked), &editable);
}

std::vector<core::BrickKey> write(LabelPrograms& programs, VoxelFields& fields,
    BeforeImages& before, const core::LabelOutlined& edit)
{
    const std::vector<core::RelabelListed::Brick> bricks = core::voxelsWithin(edit, fields.grid());
    const AskedBytes asked(bricks, &core::RelabelListed::Brick::asked);
    Program& kernel = programs.following("OUTLINED", edit.editable.has_value());
    BindEditable editable(programs, fields, edit.editable);
    setCodes(kernel, edit.lowCode, edit.highCode);
    return label(
        kernel, fields, before, edit.target, numbersOf(bricks),
        [&](const std::vector<std::uint32_t>& listed) {
            asked(listed);
            fields.codes().bindUnit(0);
        },
        &editable);
}

std::vector<core::BrickKey> write(
    LabelPrograms& programs, VoxelFields& fields, BeforeImages& before, const core::MapLabels& edit)
{
    const Buffer becomes = bufferOf(
        "mapped labels", std::vector<std::uint32_t>(edit.becomes.begin(), edit.becomes.end()));
    core::LabelTarget target{.plane = edit.plane};
    target.overwritable.set(); // the table alone says who keeps a voxel
    BindEditable editable(programs, fields, edit.editable);
    return label(
        programs.following("MAPPED", edit.editable.has_value()), fields, before, target,
        edit.becomes[0] == 0 ? fields.labelledBricks() : allBricks(fields),
        [&becomes](
            const std::vector<std::uint32_t>&) { becomes.bindBase(GL_SHADER_STORAGE_BUFFER, 2); },
        &editable);
}

std::vector<core::BrickKey> write(
    LabelPrograms& programs, VoxelFields& fields, BeforeImages& before, const core::MapPlanes& edit)
{
    std::vector<core::BrickKey> keys;
    for (const core::MapLabels& plane : edit.planes) {
        const std::vector<core::BrickKey> its = write(programs, fields, before, plane);
        keys.insert(keys.end(), its.begin(), its.end());
    }
    return keys;
}

} // namespace

Program& LabelPrograms::following(const char* rule, bool editable)
{
    Program& known = m_known[nameOf(rule, editable)];
    if (!known) {
        const char* path = "kernels/labels/chooseLabel.comp";
        ShaderDefines defines{{rule, 1}};
        if (editable)
            defines.push_back({"EDITABLE", 1});
        known = Program(
            m_library, ComputeProgramOptions{.label = path, .path = path, .defines = defines});
    }
    return known;
}

Program& LabelPrograms::scissorsCast()
{
    if (!m_scissorsCast) {
        const char* path = "kernels/labels/scissorsCast.comp";
        m_scissorsCast =
            Program(m_library, ComputeProgramOptions{.label = path, .path = path, .defines = {}});
    }
    return m_scissorsCast;
}

std::vector<core::BrickKey> writeLabels(LabelPrograms& programs, VoxelFields& fields,
    BeforeImages& before, core::LabelWrites::Pointer edit)
{
    return std::visit(
        [&](const auto* known) { return write(programs, fields, before, *known); }, edit);
}

std::vector<std::uint32_t> bricksConcerned(VoxelFields& fields, const core::LabelThreshold& edit)
{
    const core::VoxelBox whole{glm::ivec3(0), fields.grid().volumeSize};
    const std::vector<std::uint32_t> met =
        core::bricksMeeting(edit.box.value_or(whole), fields.grid());
    const std::vector<std::uint32_t> held = edit.how == core::LabelThreshold::How::Add
        ? std::vector<std::uint32_t>()
        : heldAmong(fields, edit.target.plane, met);
    if (edit.how == core::LabelThreshold::How::Subtract)
        return holdingCodes(fields, held, edit.lowCode, edit.highCode);
    // Where no value is chosen, only what is held can change.
    const std::vector<std::uint32_t> holding =
        holdingCodes(fields, met, edit.lowCode, edit.highCode);
    std::vector<std::uint32_t> either;
    std::set_union(
        holding.begin(), holding.end(), held.begin(), held.end(), std::back_inserter(either));
    return either;
}

std::vector<core::BrickKey> writeThreshold(LabelPrograms& programs, VoxelFields& fields,
    BeforeImages& before, const core::LabelThreshold& edit,
    const std::vector<std::uint32_t>& bricks)
{
    Program& kernel = programs.following("THRESHOLD", edit.editable.has_value());
    BindEditable editable(programs, fields, edit.editable);
    setCodes(kernel, edit.lowCode, edit.highCode);
    const core::VoxelBox box =
        edit.box.value_or(core::VoxelBox{glm::ivec3(0), fields.grid().volumeSize});
    kernel.set("how", unsigned(edit.how))
        .set("onlyVisible", edit.onlyVisible)
        .set("boxFrom", box.minimum)
        .set("boxTo", box.maximum);
    return label(
        kernel, fields, before, edit.target, bricks,
        [&fields](const std::vector<std::uint32_t>&) {
            fields.codes().bindUnit(0);
            fields.radiation().bindUnit(2);
            fields.codeRanges().bindUnit(3);
        },
        &editable);
}

std::vector<std::uint32_t> bricksConcerned(VoxelFields& fields, const core::LabelScissors& edit)
{
    const std::vector<std::uint32_t> near =
        holdingCodes(fields, core::bricksNear(edit, fields.grid()), edit.lowCode, edit.highCode);
    return edit.erases() ? heldAmong(fields, edit.target.plane, near) : near;
}

std::vector<core::BrickKey> writeScissors(LabelPrograms& programs, VoxelFields& fields,
    BeforeImages& before, const core::LabelScissors& edit, const Buffer& reach,
    const std::vector<std::uint32_t>& bricks)
{
    using core::fixedPoint::round14;
    Program& kernel = programs.following("SCISSORS", edit.editable.has_value());
    BindEditable editable(programs, fields, edit.editable);
    setCodes(kernel, edit.lowCode, edit.highCode);
    setHidden(kernel, edit.frame.hidden);
    kernel.set("planePerI", round14(edit.frame.planePerI))
        .set("planePerJ", round14(edit.frame.planePerJ))
        .set("planePerK", round14(edit.frame.planePerK))
        .set("pitch", edit.frame.pitch)
        .set("maskFirst", edit.mask.first)
        .set("maskSize", edit.mask.size)
        .set("outside", edit.outside)
        .set("erases", edit.erases())
        .set("erased", edit.erased);
    const BrickPlaces places(edit.frame, fields.grid());
    return label(
        kernel, fields, before, edit.target, bricks,
        [&](const std::vector<std::uint32_t>& listed) {
            places(listed);
            reach.bindBase(GL_SHADER_STORAGE_BUFFER, 3);
            fields.codes().bindUnit(0);
        },
        &editable);
}

} // namespace gpu
