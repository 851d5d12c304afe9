// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <QObject>
#include <QPoint>

#include <glm/glm.hpp>

#include <functional>
#include <utility>

class QMenu;
class QWidget;

namespace ui {

struct PointedVoxel;
class Workspace;

/// What a view offers about the voxel under the pointer: the island of a segment that it lies in is
/// removed, kept alone, or given to another segment, and what PlaceMenu.h adds. The session is
/// asked first whose the voxel is, so the menu opens a moment later, unless the user has gone on
/// meanwhile: a press, a wheel or a key anywhere, or another such request, withdraws it. Where
/// there is no voxel, the menu is about the view alone.
class VoxelMenu : public QObject {
    Q_OBJECT

public:
    /// Begins a request, and withdraws the one that the view made before. It deletes itself.
    /// @param view owns it, and the menu
    /// @param at on the screen
    VoxelMenu(Workspace& workspace, QWidget& view, const QPoint& at);

    /// Opens the menu when the session has answered; outside of the volume as openElsewhere().
    /// @param placeLps the voxel nearest to it is meant
    void openAbout(const glm::dvec3& placeLps);
    /// Opens a menu at once that is about no voxel: the window presets, and what the view offers.
    void openElsewhere();
    /// What the view offers besides, below the entries about the voxel.
    void addAtEnd(std::function<void(QMenu&)> more) { m_more = std::move(more); }
    [[nodiscard]] bool withdrawn() const { return m_withdrawn; }
    void withdraw();

protected:
    bool eventFilter(QObject* watched, QEvent* event) override;

private:
    void open(const PointedVoxel& pointed);
    /// @return null where none may open now
    [[nodiscard]] QMenu* newMenu(const char* name);
    void addEntries(QMenu& menu, int label, const glm::dvec3& placeLps) const;
    [[nodiscard]] QString whyNot(int label) const;

    Workspace& m_workspace;
    QWidget& m_view;
    QPoint m_at;
    std::function<void(QMenu&)> m_more; ///< empty: nothing
    bool m_withdrawn = false;
};

} // namespace ui
