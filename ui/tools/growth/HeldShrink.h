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

/// Takes a growth back from a sketch, one generation after the other, as long as the pen is held
/// (core::ShrinkAt with steps). It is one open edit of the session. The next generation is asked
/// for when the engine has done the one before, so it stops at once when the pen is lifted; the
/// edit then becomes one row. GUI thread.
class HeldShrink : public QObject {
    Q_OBJECT

public:
    explicit HeldShrink(Workspace& workspace, QObject* parent = nullptr);

    /// Begins with the sketched voxels and the voxels that descend from them.
    /// @param voxels index space; at least one
    /// @return whether it has begun; if not, the workspace has told the user why
    bool begin(const std::vector<glm::ivec3>& voxels);
    /// Ends it.
    /// @param kept true: what was taken back stays so; false: everything is restored
    void end(bool kept);
    /// Whether it has begun and end() was not called yet.
    [[nodiscard]] bool on() const { return m_on; }
    /// Whether the session has refused the edit after it began, so that nothing is taken back.
    [[nodiscard]] bool refused() const;

    /// A text on how far it has come, and why it goes no further: "3 generations back: takes 12.4
    /// mL". Empty while it is not on.
    [[nodiscard]] QString words() const;

Q_SIGNALS:
    void changed();

private:
    void goOn();
    /// The session, if the edit that is open there is still this one; another edit or undo may have
    /// ended it.
    [[nodiscard]] core::EditSession* open() const;

    Workspace& m_workspace;
    QTimer m_pace;
    bool m_on = false;
    int m_steps = 0; ///< generations asked for so far
};

} // namespace ui
