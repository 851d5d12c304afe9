// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <QObject>

#include <optional>
#include <utility>

namespace ui {

class Workspace;

/// To which values the seeds of the active segment would narrow the next growth's interval (mean ±
/// k σ), as the engine itself would: it follows seeds, interval, k and segment.
class SeedBand : public QObject {
    Q_OBJECT

public:
    explicit SeedBand(Workspace& workspace, QObject* parent = nullptr);

    /// Modality units, inclusive; none where it is off or nothing lies around seeds. An interval
    /// that no value is in has its ends the wrong way round.
    [[nodiscard]] const std::optional<std::pair<double, double>>& values() const
    {
        return m_values;
    }

Q_SIGNALS:
    void changed();

private:
    void ask();
    void set(const std::optional<std::pair<double, double>>& values);

    Workspace& m_workspace;
    std::optional<std::pair<double, double>> m_values;
    bool m_waiting = false; ///< for an answer
    bool m_stale = false; ///< ask once more when it is there
};

} // namespace ui
