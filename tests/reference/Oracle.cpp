// SPDX-License-Identifier: Apache-2.0
#include "tests/reference/Oracle.h"

#include "core/brick/ThreadWithoutVoxels.h"
#include "core/document/Document.h"
#include "core/growth/SeedWord.h"
#include "tests/reference/fields/Radiation.h"
#include "tests/reference/growth/Spread.h"
#include "tests/reference/sculpt/LayerWrites.h"

#include <algorithm>

namespace reference {

namespace {

auto refuse(const char* field, const char* reason)
{
    return core::failure(
        core::ErrorCode::InvalidField, QLatin1String(field), QLatin1String(reason));
}

// Why an extension is refused by an open edit for which it is not meant.

const char* notMeantBy(const core::DrillPath&)
{
    return "the open edit is no stroke of drill or laser";
}

const char* notMeantBy(const core::CapsulePath&)
{
    return "the open edit is no stroke of a brush";
}

const char* notMeantBy(const core::PeelDepth&)
{
    return "the open edit is no peel";
}

const char* notMeantBy(const core::ShrinkTo&)
{
    return "the open edit is no shrinking";
}

const char* notMeantBy(const core::CutFurther&)
{
    return "the open edit is no cut backwards";
}

const char* notMeantBy(const core::ForgetSpread&)
{
    return "the open edit does not grow from seeds";
}

const char* notMeantBy(const core::GrowAdvance&)
{
    return "the open edit is no growth";
}

const char* notMeantBy(const core::GrowPause&)
{
    return "the open edit is no growth";
}

const char* notMeantBy(const core::GrowAnew&)
{
    return "the open edit is no growth";
}

} // namespace

core::Result<void> Oracle::openVolume(const glm::ivec3& size, std::span<const std::uint16_t> codes)
{
    if (size.x < 1 || size.y < 1 || size.z < 1
        || codes.size() != std::size_t(size.x) * std::size_t(size.y) * std::size_t(size.z))
        return core::failure(core::ErrorCode::InvalidGeometry, QStringLiteral("volume"));
    m_open.reset();
    m_tolerance.reset();
    m_codes = {size, {codes.begin(), codes.end()}};
    m_fields = DenseFields(size);
    m_muted.reset();
    return {};
}

core::Ticket Oracle::submit(core::EngineCommand command)
{
    const core::VoxelsAllowed engine; // it has no thread of its own
    const core::Ticket ticket = ++m_lastTicket;
    Outcome outcome = std::visit([this](auto& known) { return carryOut(known); }, command);
    if (outcome && !*outcome)
        return ticket;
    core::EngineResult result = outcome ? std::move(**outcome) : core::EngineResult{};
    if (!outcome)
        result.error = outcome.error();
    result.ticket = ticket;
    m_results.push_back(std::move(result));
    if (m_wakeUp)
        m_wakeUp();
    return ticket;
}

std::vector<core::EngineResult> Oracle::collect()
{
    return std::exchange(m_results, {});
}

DenseArray<std::uint8_t> Oracle::carved() const
{
    return radiation(m_fields.composedCoverage(m_muted));
}

core::Result<Oracle::Work> Oracle::begin(core::SeedPlacement& edit)
{
    if (edit.label == 0)
        return refuse("label", "0 is no segment");
    for (const std::vector<glm::ivec3>* voxels : {&edit.taken, &edit.voxels}) {
        for (const glm::ivec3& voxel : *voxels) {
            if (!m_codes.contains(voxel))
                return refuse("voxels", "outside the volume");
        }
    }
    placeSeeds(m_fields, edit);
    return Done{};
}

core::Result<void> Oracle::checkGroups(const std::vector<core::SeedGroup>& groups) const
{
    if (!core::isSound(groups))
        return refuse("seedGroups", "are not sound");
    for (const core::SeedGroup& group : groups) {
        for (const glm::ivec3& voxel : group.voxels) {
            if (!m_codes.contains(voxel))
                return refuse("voxels", "outside the volume");
        }
    }
    return {};
}

core::Result<void> Oracle::check(const core::GrowBurst& edit) const
{
    if (edit.connectivity != 6 && edit.connectivity != 18 && edit.connectivity != 26)
        return refuse("connectivity", "is not 6, 18 or 26");
    if (!core::isSound(edit))
        return refuse("limits", "are not sound");
    return checkGroups(edit.seedGroups);
}

core::Result<Oracle::Work> Oracle::begin(core::GrowBurst& edit)
{
    if (const core::Result<void> checked = check(edit); !checked)
        return tl::unexpected(checked.error());
    return Growth(m_codes, m_fields.composedCoverage(m_muted), m_fields, std::move(edit));
}

core::Result<Oracle::Work> Oracle::begin(core::ShrinkGrowth& edit)
{
    if (edit.keep > edit.generation)
        return refuse("keep", "is more than there is");
    return Shrunk{edit, shrinkGrowth(m_fields, edit)};
}

core::Result<void> Oracle::checkCut(const core::CutGrowth& edit) const
{
    if (edit.connectivity != 6 && edit.connectivity != 18 && edit.connectivity != 26)
        return refuse("connectivity", "is not 6, 18 or 26");
    if (edit.steps < 1)
        return refuse("steps", "are none");
    for (const glm::ivec3& voxel : edit.voxels) {
        if (!m_codes.contains(voxel))
            return refuse("voxels", "outside the volume");
    }
    return {};
}

core::Result<Oracle::Work> Oracle::begin(core::CutGrowth& edit)
{
    if (const core::Result<void> checked = checkCut(edit); !checked)
        return tl::unexpected(checked.error());
    core::Result<CutDone> done = cutGrowth(m_fields, edit);
    if (!done)
        return tl::unexpected(done.error());
    return CutBack{edit, *std::move(done)};
}

core::Result<Oracle::Work> Oracle::begin(core::PaintBarrier& edit)
{
    if (!core::isSound(edit.frame))
        return refuse("frame", "is not sound");
    return Capsules(m_codes, m_fields, edit);
}

core::Result<Oracle::Work> Oracle::begin(core::BarrierListed& edit)
{
    if (!core::isSound(edit, core::BrickGrid{m_codes.size}.brickCount()))
        return refuse("bricks", "are not sound");
    writeBarriers(m_fields, edit);
    return Done{};
}

core::Result<Oracle::Work> Oracle::begin(core::SpreadLabels& edit)
{
    if (!core::isSound(edit, m_codes.size))
        return refuse("spread", "is not sound");
    if (const core::Result<void> spread = spreadLabels(m_codes, m_fields, edit); !spread)
        return tl::unexpected(spread.error());
    return Spread{};
}

namespace {

bool isSound(const core::CutFrame& frame)
{
    return frame.pitch >= 1 && frame.rampHalfWidth >= 1 && frame.gapSamples >= 1;
}

constexpr const char* unsoundHidden = "is not sound";
constexpr const char* unsound = "pitch, rampHalfWidth and gapSamples are at least 1";

} // namespace

core::Result<Oracle::Work> Oracle::begin(core::LaserCut& edit)
{
    if (!isSound(edit.frame))
        return refuse("frame", unsound);
    if (!core::isSound(edit.frame.hidden))
        return refuse("hidden", unsoundHidden);
    if (!core::isSound(edit))
        return refuse("laser", "is not sound");
    return Laser(m_codes, carved(), m_fields, edit);
}

core::Result<Oracle::Work> Oracle::begin(core::ShellPeel& edit)
{
    if (!isSound(edit.frame))
        return refuse("frame", unsound);
    if (!core::isSound(edit.frame.hidden))
        return refuse("hidden", unsoundHidden);
    return Peel(m_codes, carved(), m_fields, edit);
}

core::Result<Oracle::Work> Oracle::begin(core::OutlineCut& edit)
{
    if (!isSound(edit.frame))
        return refuse("frame", unsound);
    if (!core::isSound(edit.frame.hidden))
        return refuse("hidden", unsoundHidden);
    return Done{cutWithScissors(m_codes, carved(), m_fields, edit)};
}

core::Result<Oracle::Work> Oracle::begin(core::DrillCut& edit)
{
    if (!isSound(edit.frame))
        return refuse("frame", unsound);
    if (!core::isSound(edit.frame.hidden))
        return refuse("hidden", unsoundHidden);
    return Drill(m_codes, carved(), m_fields, edit);
}

core::Result<Oracle::Work> Oracle::begin(core::EraseLabel& edit)
{
    if (edit.label == 0)
        return refuse("label", "0 is no segment");
    eraseLabel(m_fields, edit);
    return Done{};
}

core::Result<Oracle::Work> Oracle::begin(core::PaintLabel& edit)
{
    if (edit.label == 0)
        return refuse("label", "0 is no segment");
    if (!core::isSound(edit.frame))
        return refuse("frame", "is not sound");
    if (edit.edges && !core::isSound(*edit.edges, core::BrickGrid{m_codes.size}))
        return refuse("edges", "is not sound");
    if (const auto checked = core::checkSound(edit.editable); !checked)
        return tl::unexpected(checked.error());
    return Capsules(m_codes, m_fields, edit);
}

core::Result<Oracle::Work> Oracle::begin(core::CapsuleCut& edit)
{
    if (!core::isSound(edit.frame))
        return refuse("frame", "is not sound");
    if (!core::isSound(edit.hidden))
        return refuse("hidden", unsoundHidden);
    return Capsules(m_codes, m_fields, edit);
}

core::Result<Oracle::Work> Oracle::begin(core::LabelCarved& edit)
{
    if (const auto checked = core::checkSound(edit, core::BrickGrid{m_codes.size}); !checked)
        return tl::unexpected(checked.error());
    labelCarved(m_codes, m_fields, edit);
    return Done{};
}

core::Result<Oracle::Work> Oracle::begin(core::LabelSeen& edit)
{
    if (const auto checked = core::checkSound(edit, core::BrickGrid{m_codes.size}); !checked)
        return tl::unexpected(checked.error());
    labelSeen(m_codes, m_fields.composedCoverage(m_muted), m_fields, edit);
    return Done{};
}

core::Result<Oracle::Work> Oracle::begin(core::LabelListed& edit)
{
    if (const auto checked = core::checkSound(edit, core::BrickGrid{m_codes.size}); !checked)
        return tl::unexpected(checked.error());
    labelListed(m_codes, m_fields, edit);
    return Done{};
}

core::Result<Oracle::Work> Oracle::begin(core::LabelPlanes& edit)
{
    if (const auto checked = core::checkSound(edit, core::BrickGrid{m_codes.size}); !checked)
        return tl::unexpected(checked.error());
    labelPlanes(m_codes, m_fields, edit);
    return Done{};
}

core::Result<Oracle::Work> Oracle::begin(core::RelabelListed& edit)
{
    if (const auto checked = core::checkSound(edit, core::BrickGrid{m_codes.size}); !checked)
        return tl::unexpected(checked.error());
    relabelListed(m_codes, m_fields, edit);
    return Done{};
}

core::Result<Oracle::Work> Oracle::begin(core::LabelOutlined& edit)
{
    if (const auto checked = core::checkSound(edit, core::BrickGrid{m_codes.size}); !checked)
        return tl::unexpected(checked.error());
    labelOutlined(m_codes, m_fields, edit);
    return Done{};
}

core::Result<Oracle::Work> Oracle::begin(core::LabelThreshold& edit)
{
    if (const auto checked = core::checkSound(edit, core::BrickGrid{m_codes.size}); !checked)
        return tl::unexpected(checked.error());
    labelThreshold(m_codes, m_fields.composedCoverage(m_muted), m_fields, edit);
    return Done{};
}

core::Result<Oracle::Work> Oracle::begin(core::LabelScissors& edit)
{
    if (const auto checked = core::checkSound(edit, core::BrickGrid{m_codes.size}); !checked)
        return tl::unexpected(checked.error());
    labelScissors(m_codes, m_fields, edit);
    return Done{};
}

core::Result<Oracle::Work> Oracle::begin(core::MapLabels& edit)
{
    if (const auto checked = core::checkSound(edit, core::BrickGrid{m_codes.size}); !checked)
        return tl::unexpected(checked.error());
    mapLabels(m_codes, m_fields, edit);
    return Done{};
}

core::Result<Oracle::Work> Oracle::begin(core::MapPlanes& edit)
{
    if (const auto checked = core::checkSound(edit, core::BrickGrid{m_codes.size}); !checked)
        return tl::unexpected(checked.error());
    mapPlanes(m_codes, m_fields, edit);
    return Done{};
}

core::Result<Oracle::Work> Oracle::begin(core::CoverLabel& edit)
{
    if (edit.label == 0)
        return refuse("label", "0 is no segment");
    coverLabel(m_fields, edit);
    return Done{};
}

core::Result<Oracle::Work> Oracle::begin(core::FoldLayer& edit)
{
    if (edit.into == edit.layer)
        return refuse("into", "is the layer itself");
    foldLayer(m_fields, edit);
    return Done{};
}

Oracle::Outcome Oracle::carryOut(core::BeginEdit& command)
{
    if (m_open)
        return refuse("transaction", "another edit is open");
    m_tolerance.reset();
    DenseFields before = m_fields;
    auto work = std::visit([this](auto& edit) { return begin(edit); }, command.edit);
    if (!work)
        return tl::unexpected(work.error());
    m_open.emplace(Transaction{std::move(before), std::move(*work)});
    return std::nullopt;
}

core::Result<void> Oracle::extend(Drill& stroke, core::DrillPath& path)
{
    stroke.extend(path.samples);
    return {};
}

core::Result<void> Oracle::extend(Laser& stroke, core::DrillPath& path)
{
    stroke.extend(path.samples);
    return {};
}

core::Result<void> Oracle::extend(Capsules& stroke, core::CapsulePath& path)
{
    stroke.extend(path);
    return {};
}

core::Result<void> Oracle::extend(Peel& peel, core::PeelDepth& depth)
{
    if (depth.depth < 0)
        return refuse("depth", "is below 0");
    peel.setDepth(depth.depth);
    return {};
}

core::Result<void> Oracle::extend(Shrunk& shrunk, core::ShrinkTo& to)
{
    if (to.keep > shrunk.edit.generation)
        return refuse("keep", "is more than there is");
    shrunk.edit.keep = to.keep;
    shrunk.edit.keepSeeds = to.keep == 0;
    m_fields = m_open->before;
    shrunk.to = shrinkGrowth(m_fields, shrunk.edit);
    return {};
}

/// Begins again for every step, as far as it is not refused.
core::Result<void> Oracle::extend(CutBack& cut, core::CutFurther& further)
{
    if (cut.edit.how != core::CutGrowth::How::Backwards)
        return refuse("extension", notMeantBy(further));
    if (further.steps < 1)
        return refuse("steps", "are none");
    using Bound = core::BackwardProgress::Bound;
    while (cut.edit.steps < further.steps && cut.done.backwards.bound == Bound::None) {
        core::CutGrowth next = cut.edit;
        ++next.steps;
        DenseFields fields = m_open->before;
        core::Result<CutDone> done = cutGrowth(fields, next);
        if (!done) {
            cut.done.backwards.bound = Bound::Everything;
            break;
        }
        m_fields = std::move(fields);
        cut = {next, *std::move(done)};
    }
    return {};
}

core::Result<void> Oracle::extend(Spread&, core::ForgetSpread&)
{
    return {};
}

core::Result<void> Oracle::extend(Growth& growth, core::GrowAdvance& advance)
{
    growth.advance(advance.steps);
    return {};
}

/// What it was told before is already done.
core::Result<void> Oracle::extend(Growth&, core::GrowPause&)
{
    return {};
}

core::Result<void> Oracle::extend(Growth& growth, core::GrowAnew& anew)
{
    if (anew.burst.plane != growth.plane())
        return refuse("plane", "is another one");
    if (const core::Result<void> checked = check(anew.burst); !checked)
        return checked;
    m_fields = m_open->before;
    m_open->work.emplace<Growth>(m_codes, m_fields.composedCoverage(m_muted), m_fields, anew.burst);
    return {};
}

/// An open edit for which an extension is not meant.
template <class Other, class Extension>
core::Result<void> Oracle::extend(Other&, Extension& extension)
{
    return refuse("extension", notMeantBy(extension));
}

Oracle::Outcome Oracle::carryOut(core::ExtendEdit& command)
{
    if (!m_open)
        return refuse("transaction", "no edit is open");
    const core::Result<void> extended =
        std::visit([this](auto& work, auto& extension) { return extend(work, extension); },
            m_open->work, command.extension);
    if (!extended)
        return tl::unexpected(extended.error());
    return std::nullopt;
}

core::Result<void> Oracle::checkImages(
    const std::vector<core::BrickImage>& images, bool mayBeEmpty) const
{
    if (m_open)
        return refuse("transaction", "an edit is open");
    for (const core::BrickImage& image : images) {
        if (!m_fields.holds(image.key))
            return refuse("brick", "not in this volume");
        const std::size_t whole =
            std::size_t(core::BrickGrid::voxelsPerBrick * core::bytesPerVoxel(image.key.field));
        if (image.bytes.size() != whole && !(mayBeEmpty && image.bytes.empty()))
            return refuse("bytes", "neither none nor a whole brick");
    }
    return {};
}

std::vector<core::BrickImage> Oracle::imagesNow(const std::vector<core::BrickKey>& keys) const
{
    std::vector<core::BrickImage> images;
    for (const core::BrickKey& key : keys)
        images.push_back({.key = key, .bytes = m_fields.readBrick(key)});
    return images;
}

Oracle::Outcome Oracle::put(const core::LabelGuard& guard, const std::vector<core::BrickImage>& now,
    const std::vector<core::BrickImage>& images)
{
    if (const core::Result<void> checked = core::checkGuard(guard, now, images); !checked)
        return tl::unexpected(checked.error());
    m_tolerance.reset();
    const DenseFields before = m_fields;
    for (const core::BrickImage& image : images)
        m_fields.writeBrick(image.key, image.bytes.read());
    core::EngineResult result;
    result.changes = DenseFields::changes(before, m_fields);
    result.facts = core::factsOf(result.changes, core::BrickGrid{m_codes.size});
    result.statistics = core::statisticsOf(result.facts);
    return result;
}

Oracle::Outcome Oracle::carryOut(core::SwapBricks& command)
{
    if (const core::Result<void> checked = checkImages(command.bricks, true); !checked)
        return tl::unexpected(checked.error());
    return put(command.guard, imagesNow(core::bricksToRead(command.bricks, command.guard)),
        command.bricks);
}

Oracle::Outcome Oracle::carryOut(core::XorBricks& command)
{
    if (const core::Result<void> checked = checkImages(command.differences, false); !checked)
        return tl::unexpected(checked.error());
    const std::vector<core::BrickImage> now =
        imagesNow(core::bricksToRead(command.differences, command.guard));
    return put(command.guard, now, core::laidOver(command.differences, now));
}

Oracle::Outcome Oracle::carryOut(core::ReadSeedWords& command)
{
    core::EngineResult result;
    for (const glm::ivec3& voxel : command.voxels) {
        if (!m_codes.contains(voxel))
            return refuse("voxels", "outside the volume");
        result.seedWords.push_back(m_fields.seedWords(command.plane).at(voxel));
    }
    return result;
}

Oracle::Outcome Oracle::carryOut(core::MuteLayers& command)
{
    if (m_open)
        return refuse("transaction", "an edit is open");
    m_tolerance.reset();
    m_muted = command.muted;
    return core::EngineResult{};
}

Oracle::Outcome Oracle::carryOut(core::ReadBricks& command)
{
    core::EngineResult result;
    for (const core::BrickKey& key : command.keys) {
        if (!m_fields.holds(key))
            return refuse("brick", "not in this volume");
        result.changes.push_back({key, {}, m_fields.readBrick(key)});
    }
    return result;
}

} // namespace reference
