// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/base/Result.h"
#include "core/history/History.h"
#include "tests/peers/ItkMask.h"

#include <array>
#include <cstdint>
#include <memory>
#include <vector>

namespace core {
class EditEngine;
class EditSession;
struct Document;
struct VolumeGeometry;
} // namespace core

namespace peer {

/// A series of the shared data, and the values of which a segment is made.
struct RealSeries {
    const char* name;
    const char* folder;
    double lower; ///< modality units
    double upper;
};
/// A skull and an abdomen in CT, and a brain in MR.
[[nodiscard]] const std::array<RealSeries, 3>& realSeries();

/// A session on a real series in which one segment is as whole-segment operations find it.
class RealSegment {
public:
    /// What it is before an operation.
    enum class State {
        Empty,
        Thresholded, ///< by the values of RealSeries: with islands, holes and noise
        /// Its largest part, wrapped, of which every fourth slice across K is left: as if drawn.
        Drawn,
    };
    static constexpr int label = 1;
    static constexpr int slicesApart = 4; ///< those that are drawn

    /// Opens it and makes its states.
    /// @param longest only voxels around the middle, so many along each axis at most; 0: all
    /// @return none without shared data. Errors: those of loading and of edits.
    [[nodiscard]] static core::Result<std::unique_ptr<RealSegment>> open(
        core::EditEngine& engine, const RealSeries& series, int longest);
    ~RealSegment();

    /// Takes back what was done since, and goes to a state.
    [[nodiscard]] core::Result<void> goTo(State state);
    /// Leaves every fourth slice of the segment, as of State::Drawn.
    [[nodiscard]] core::Result<void> leaveDrawnSlices();
    [[nodiscard]] const std::vector<std::uint8_t>& labels(State state) const;
    [[nodiscard]] GridMask mask(State state) const;

    [[nodiscard]] core::EditSession& session() const { return *m_session; }
    [[nodiscard]] const core::Document& document() const;
    [[nodiscard]] const core::VolumeGeometry& geometry() const;
    /// Modality values, x fastest.
    [[nodiscard]] const std::vector<float>& values() const { return m_values; }
    /// The codes of these values.
    [[nodiscard]] const std::vector<std::uint16_t>& codes() const { return m_codes; }
    [[nodiscard]] const RealSeries& series() const { return m_series; }

private:
    explicit RealSegment(const RealSeries& series);
    core::Result<void> makeStates();
    core::Result<void> keep(State state);

    RealSeries m_series;
    std::vector<float> m_values;
    std::vector<std::uint16_t> m_codes;
    std::unique_ptr<core::EditSession> m_session;
    std::array<core::RowId, 3> m_rows{};
    std::array<std::vector<std::uint8_t>, 3> m_labels;
};

} // namespace peer
