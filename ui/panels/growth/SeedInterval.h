// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <QToolButton>

#include <glm/glm.hpp>

#include <cstdint>
#include <vector>

namespace ui {

class Workspace;

/// A button that sets the growth's interval around the values under the active segment's seeds, and
/// what is known of those values.
class SeedInterval : public QToolButton {
    Q_OBJECT

public:
    explicit SeedInterval(Workspace& workspace, QWidget* parent = nullptr);

    /// Asks the engine for the values, where seeds have come or gone.
    void ask();
    /// Another study: nothing is known.
    void forget();
    /// Under the seeds, modality units.
    [[nodiscard]] const std::vector<double>& values() const { return m_values; }
    /// "12 seed voxels · 41.0 ± 3.2 HU" of the active segment; where it has none, that there are
    /// @p seeds of others.
    [[nodiscard]] QString text(int seeds) const;

Q_SIGNALS:
    void valuesChanged();
    /// The settings of the growth have another interval.
    void intervalTaken();

private:
    void take(double deviations);

    Workspace& m_workspace;
    std::vector<glm::ivec3> m_voxels; ///< asked about last
    std::vector<double> m_values; ///< there
    std::uint64_t m_asked = 0; ///< questions; only the last counts
};

} // namespace ui
