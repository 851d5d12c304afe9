// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <QObject>

#include <optional>
#include <utility>
#include <vector>

namespace core {
struct CodeInterval;
struct ProbedSeeds;
} // namespace core

namespace ui {

class Workspace;

/// The ranges of values that the strokes of seeds allow together, in modality units, both ends
/// inclusive.
struct SeedStretches {
    using Stretch = std::pair<double, double>;
    std::vector<Stretch> values{}; ///< ascending, not overlapping; empty if no value qualifies
    std::optional<Stretch> newest{}; ///< the range of the latest stroke, if it is not the only one
    int strokes = 0;
    bool others = false; ///< there are also seeds that belong to no stroke, such as painted ones
    bool operator==(const SeedStretches&) const = default;
};

/// The values to which the seeds of the active segment would narrow the interval of the next growth
/// (mean ± k σ of each stroke), computed by the engine with the growth's own rule. It follows
/// seeds, interval, k and segment.
class SeedBand : public QObject {
    Q_OBJECT

public:
    explicit SeedBand(Workspace& workspace, QObject* parent = nullptr);

    /// None if the limit is off or there are no values around seeds.
    [[nodiscard]] const std::optional<SeedStretches>& stretches() const { return m_stretches; }

Q_SIGNALS:
    void changed();

private:
    void ask();
    [[nodiscard]] std::optional<SeedStretches> stretchesOf(
        const std::vector<core::ProbedSeeds>& seeds, const core::CodeInterval& interval) const;
    void set(const std::optional<SeedStretches>& stretches);

    Workspace& m_workspace;
    std::optional<SeedStretches> m_stretches;
    bool m_waiting = false; ///< waits for an answer
    bool m_stale = false; ///< ask again after the answer
};

} // namespace ui
