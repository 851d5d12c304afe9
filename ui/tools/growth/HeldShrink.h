// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <glm/glm.hpp>

#include <QObject>
#include <QString>
#include <QTimer>

#include <vector>

namespace core {
class EditSession;
}

namespace ui {

class Workspace;

/// Takes a growth back from a sketch, generation by generation, as long as the pen is held
/// (core::ShrinkAt with steps): one open edit, which goes a step further whenever the engine has
/// done the one before, and becomes one row when it ends.
class HeldShrink : public QObject {
    Q_OBJECT

public:
    explicit HeldShrink(Workspace& workspace, QObject* parent = nullptr);

    /// Takes the sketch and what descends from it. @param voxels at least one
    /// @return whether it has begun; if not, the workspace has been told why
    bool begin(const std::vector<glm::ivec3>& voxels);
    /// Ends it. @param kept whether what is taken stays so
    void end(bool kept);
    [[nodiscard]] bool on() const { return m_on; }
    /// Whether it is on, but was refused: it takes nothing.
    [[nodiscard]] bool refused() const;

    /// "3 generations back: takes 12.4 mL", and why it goes no further; empty while it is not on.
    [[nodiscard]] QString words() const;

Q_SIGNALS:
    void changed();

private:
    void goOn();
    /// Its session, while the edit that is open there is its own: another edit, or undo, ends it.
    [[nodiscard]] core::EditSession* open() const;

    Workspace& m_workspace;
    QTimer m_pace;
    bool m_on = false;
    int m_steps = 0; ///< that were asked for
};

} // namespace ui
