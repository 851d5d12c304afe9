// SPDX-License-Identifier: Apache-2.0
#include "tests/peers/cases/RealSegment.h"

#include "core/edits/kinds/segments/CleanSegment.h"
#include "core/edits/kinds/segments/ReshapeSegment.h"
#include "core/edits/kinds/values/ThresholdSegment.h"
#include "core/session/EditSession.h"
#include "core/session/questions/VoxelQuestions.h"
#include "core/study/StudyLoader.h"
#include "tests/support/scenes/PlainEdits.h"
#include "tests/support/scenes/SharedData.h"

#include <algorithm>

namespace peer {

namespace {

/// The voxels around the middle of a study.
core::LoadedVolume middleOf(core::LoadedVolume study, int longest)
{
    core::VolumeGeometry& geometry = study.volume.geometry;
    const glm::ivec3 whole = geometry.size;
    const glm::ivec3 size = glm::min(whole, glm::ivec3(longest));
    if (longest <= 0 || size == whole)
        return study;
    const glm::ivec3 first = (whole - size) / 2;
    std::vector<std::uint16_t> codes;
    codes.reserve(std::size_t(size.x) * std::size_t(size.y) * std::size_t(size.z));
    for (int z = 0; z < size.z; ++z) {
        for (int y = 0; y < size.y; ++y) {
            const glm::ivec3 at = first + glm::ivec3(0, y, z);
            const auto from = study.codes.begin()
                + (std::ptrdiff_t(at.z) * whole.y + at.y) * std::ptrdiff_t(whole.x) + at.x;
            codes.insert(codes.end(), from, from + size.x);
        }
    }
    study.codes = std::move(codes);
    geometry.indexToWorld[3] = glm::dvec4(geometry.toWorld(glm::dvec3(first)), 1.0);
    geometry.size = size;
    geometry.slicePositions.clear();
    study.volume.sources.clear();
    return study;
}

core::Result<void> done(core::EditSession& session, const core::Edit& edit)
{
    if (const core::Result<void> applied = session.apply(edit); !applied)
        return applied;
    return session.settle();
}

/// Takes the slices from one to before another out of the segment.
core::Edit withoutSlices(const core::VolumeGeometry& geometry, int from, int to)
{
    const core::GrowBox box{.fromLps = geometry.toWorld({0.0, 0.0, double(from)}),
        .toLps = geometry.toWorld(glm::dvec3(geometry.size.x - 1, geometry.size.y - 1, to - 1))};
    return core::ThresholdSegment{
        .segment = RealSegment::label, .mode = core::ThresholdSegment::Mode::Subtract, .box = box};
}

} // namespace

const std::array<RealSeries, 3>& realSeries()
{
    static const std::array<RealSeries, 3> all{
        RealSeries{"skull", "ct_cranium_inv3", 226.0, 3071.0},
        RealSeries{"abdomen", "ct_abdomen_j2k_organs", -29.5, 150.5},
        RealSeries{"brain", "mr_t1_sag_mprage", 90.0, 400.0}};
    return all;
}

RealSegment::RealSegment(const RealSeries& series)
    : m_series(series)
{
}

RealSegment::~RealSegment() = default;

core::Result<std::unique_ptr<RealSegment>> RealSegment::open(
    core::EditEngine& engine, const RealSeries& series, int longest)
{
    const test::SharedCase data = test::sharedCase(QString::fromLatin1(series.folder));
    if (data.source.isEmpty())
        return std::unique_ptr<RealSegment>();
    core::Result<core::LoadedVolume> loaded = core::loadVolume(
        data.unpacked.isEmpty() ? data.source + QStringLiteral("/dicom") : data.unpacked);
    if (!loaded)
        return tl::unexpected(loaded.error());
    core::LoadedVolume study = middleOf(*std::move(loaded), longest);
    std::unique_ptr<RealSegment> opened(new RealSegment(series));
    opened->m_values.resize(study.codes.size());
    std::transform(study.codes.begin(), study.codes.end(), opened->m_values.begin(),
        [&study](int code) { return float(study.volume.encoding.value(code)); });
    opened->m_codes = study.codes;
    core::Result<std::unique_ptr<core::EditSession>> session =
        core::EditSession::create(engine, std::move(study), {});
    if (!session)
        return tl::unexpected(session.error());
    opened->m_session = *std::move(session);
    if (const core::Result<void> made = opened->makeStates(); !made)
        return tl::unexpected(made.error());
    return opened;
}

core::Result<void> RealSegment::makeStates()
{
    constexpr double wrapMm = 6.0;
    const auto then = [this](const core::Edit& edit) { return done(*m_session, edit); };
    return then(test::newSegment(QStringLiteral("A")))
        .and_then([&] { return keep(State::Empty); })
        .and_then([&] { return then(test::thresholdOf(label, m_series.lower, m_series.upper)); })
        .and_then([&] { return keep(State::Thresholded); })
        .and_then([&] {
            return then(
                core::CleanSegment{.segment = label, .rule = core::IslandRule::KeepLargest});
        })
        .and_then([&] {
            return then(core::ReshapeSegment{
                .segment = label, .operation = core::ShapeOperation::Wrap, .mm = wrapMm});
        })
        .and_then([&] { return leaveDrawnSlices(); })
        .and_then([&] { return keep(State::Drawn); });
}

core::Result<void> RealSegment::leaveDrawnSlices()
{
    const int depth = geometry().size.z;
    core::Result<void> result;
    for (int drawn = 0; result && drawn < depth - 1; drawn += slicesApart)
        result = done(
            *m_session, withoutSlices(geometry(), drawn + 1, std::min(drawn + slicesApart, depth)));
    return result;
}

core::Result<void> RealSegment::keep(State state)
{
    core::Result<std::vector<std::uint8_t>> labels = m_session->questions().labels(0);
    if (!labels)
        return tl::unexpected(labels.error());
    m_labels.at(std::size_t(state)) = *std::move(labels);
    m_rows.at(std::size_t(state)) = m_session->history().position();
    return {};
}

core::Result<void> RealSegment::goTo(State state)
{
    if (const core::Result<void> gone = m_session->goTo(m_rows.at(std::size_t(state))); !gone)
        return gone;
    return m_session->settle();
}

const std::vector<std::uint8_t>& RealSegment::labels(State state) const
{
    return m_labels.at(std::size_t(state));
}

GridMask RealSegment::mask(State state) const
{
    return {.size = geometry().size, .spacingMm = geometry().spacingMm(), .voxels = labels(state)};
}

const core::Document& RealSegment::document() const
{
    return m_session->document();
}

const core::VolumeGeometry& RealSegment::geometry() const
{
    return document().volumes.front().geometry;
}

} // namespace peer
