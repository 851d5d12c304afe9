// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/growth/ProbedVoxel.h"
#include "ui/workspace/Workspace.h"

#include <QObject>

namespace ui {

/// What is at the pointer (in the 3D view: what is seen there), or at the crosshair while it is
/// over no picture: position, voxel, value with its unit, segment, and at which tolerance it would
/// join where a field of tolerances stands. Asks the engine, one question at a time, and never
/// waits for it.
class Readout : public QObject {
    Q_OBJECT

public:
    explicit Readout(Workspace& workspace, QObject* parent = nullptr);

    /// Position and voxel at once; value and segment once the engine has answered.
    [[nodiscard]] const QString& text() const { return m_text; }

Q_SIGNALS:
    void textChanged();

private:
    void look();
    /// @param probe null: it could not be told
    void answer(const glm::ivec3& voxel, const core::ProbedVoxel* probe);
    void show(const QString& text);

    Workspace& m_workspace;
    QString m_text;
    glm::dvec3 m_lps{0.0};
    glm::ivec3 m_voxel{-1};
    bool m_asking = false;
    bool m_stale = false; ///< moved since the question was asked
};

} // namespace ui
