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

/// Which values strokes of seeds let in together. Modality units, both ends inclusive.
struct SeedStretches {
    using Stretch = std::pair<double, double>;
    std::vector<Stretch> values{}; ///< ascending, apart from each other; none: no value at all
    std::optional<Stretch> newest{}; ///< of the stroke sketched last, where it is not the only one
    int strokes = 0;
    bool others = false; ///< besides them seeds that belong to none, as painted ones
    bool operator==(const SeedStretches&) const = default;
};

/// To which values the seeds of the active segment would narrow the next growth's interval (mean ±
/// k σ of each stroke), as the engine itself would: it follows seeds, interval, k and segment.
class SeedBand : public QObject {
    Q_OBJECT

public:
    explicit SeedBand(Workspace& workspace, QObject* parent = nullptr);

    /// None where it is off or nothing lies around seeds.
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
    bool m_waiting = false; ///< for an answer
    bool m_stale = false; ///< ask once more when it is there
};

} // namespace ui
