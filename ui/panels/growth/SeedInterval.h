// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <QToolButton>

#include <glm/glm.hpp>

#include <cstdint>
#include <vector>

namespace ui {

class Workspace;

/// A button that sets the growth's interval around the values under the active segment's seeds. It
/// also knows these values.
class SeedInterval : public QToolButton {
    Q_OBJECT

public:
    explicit SeedInterval(Workspace& workspace, QWidget* parent = nullptr);

    /// Asks the engine for the values if seeds have been added or removed.
    void ask();
    /// Forgets the values, because another study was opened.
    void forget();
    /// The values under the seeds, in modality units.
    [[nodiscard]] const std::vector<double>& values() const { return m_values; }
    /// "12 seed voxels · 41.0 ± 3.2 HU" for the active segment. If it has no seeds the text tells
    /// that there are @p seeds of others.
    [[nodiscard]] QString text(int seeds) const;

Q_SIGNALS:
    void valuesChanged();
    /// The interval in the growth's settings was changed.
    void intervalTaken();

private:
    void take(double deviations);

    Workspace& m_workspace;
    std::vector<glm::ivec3> m_voxels; ///< the voxels asked about last
    std::vector<double> m_values; ///< the values at m_voxels
    std::uint64_t m_asked = 0; ///< number of questions; only the answer to the last one counts
};

} // namespace ui
