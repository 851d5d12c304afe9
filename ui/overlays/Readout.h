// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/growth/ProbedVoxel.h"
#include "ui/workspace/Workspace.h"

#include <QObject>

namespace ui {

/// The readout text for the voxel under the pointer (in the 3D view: the voxel seen there), or at
/// the crosshair while the pointer is over no picture: position, voxel, value with unit, segment,
/// and the tolerance at which it would join if there is a tolerance field. It asks the engine, one
/// question at a time, and never waits for it.
class Readout : public QObject {
    Q_OBJECT

public:
    explicit Readout(Workspace& workspace, QObject* parent = nullptr);

    /// Holds position and voxel at once; value and segment once the engine has answered.
    [[nodiscard]] const QString& text() const { return m_text; }

Q_SIGNALS:
    void textChanged();

private:
    void look();
    /// @param probe null if the engine could not answer
    void answer(const glm::ivec3& voxel, const core::ProbedVoxel* probe);
    void show(const QString& text);

    Workspace& m_workspace;
    QString m_text;
    glm::dvec3 m_lps{0.0};
    glm::ivec3 m_voxel{-1};
    bool m_asking = false;
    bool m_stale = false; ///< the position has changed since the question was asked
};

} // namespace ui
