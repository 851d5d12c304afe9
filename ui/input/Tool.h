// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "ui/geometry/ViewContext.h"

#include <QJsonObject>
#include <QObject>
#include <QString>

#include <optional>

class QPainter;
class QWidget;

namespace ui {

/// One sample of mouse or pen, in logical pixels of the view (made only in ui/input/StylusGlue).
struct PointerSample {
    QPointF position;
    double pressure = 1.0; ///< 0 … 1; always 1 for a mouse
    double timeSeconds = 0.0;
    Qt::KeyboardModifiers modifiers;
    bool eraserEnd = false;
    bool isPen = false; ///< it reports pressure
    /// For a pen: degrees from upright, positive to the right and towards the user. For a mouse: 0.
    QPointF tiltDegrees;
    /// For a pen: rotation about its own axis, clockwise, in degrees; none if it does not report
    /// it.
    std::optional<double> rotationDegrees;
};

/// A tool: what the left mouse button or the pen does. By default it ignores everything; the view
/// navigates with the other buttons. A stroke runs press → drag* → release | cancel.
class Tool : public QObject {
    Q_OBJECT

public:
    using QObject::QObject;

    [[nodiscard]] virtual QString name() const = 0; ///< short, under the icon: "Drill"
    /// The name for menus and lists, if another tool has the same short name.
    [[nodiscard]] virtual QString longName() const { return name(); }
    [[nodiscard]] virtual QString iconName() const = 0; ///< resources/icons/<name>.svg
    /// Ends a mode that a key of its own had chosen (an eraser becomes a brush again). Called when
    /// the tool's own key is pressed. @return whether it was in one
    virtual bool endMode() { return false; }
    /// What it expects next, shown in the status line.
    [[nodiscard]] virtual QString hint() const = 0;
    [[nodiscard]] virtual QString target() const { return {}; } ///< "carves layer Sculpt 1"
    /// Shown at the right end of the option bar.
    [[nodiscard]] virtual QString keys() const { return {}; }
    /// Makes the tool's widgets for the option bar; null if it has none. The parent owns the
    /// result.
    [[nodiscard]] virtual QWidget* createOptions(QWidget* /*parent*/) { return nullptr; }
    /// Settings that the tool itself holds and a session keeps (ToolSettings.h); empty if none.
    [[nodiscard]] virtual QJsonObject settingsJson() const { return {}; }
    /// Restores the settings that are present and valid.
    virtual void applySettings(const QJsonObject&) { }
    [[nodiscard]] virtual bool worksIn(const ViewContext& view) const = 0;

    /// Whether a press at this place, in a view where the tool works, belongs to the tool; else the
    /// view navigates.
    [[nodiscard]] virtual bool takes(const PointerSample&, const ViewContext&) const
    {
        return true;
    }

    virtual void press(const PointerSample&, const ViewContext&) { }
    virtual void drag(const PointerSample&, const ViewContext&) { }
    virtual void release(const PointerSample&, const ViewContext&) { }
    virtual void cancel() { }
    /// Called before something else happens: another tool is chosen, another study opened, a step
    /// undone.
    virtual void putAway() { cancel(); }
    /// Whether undo takes back the last step of what is being drawn (before it is an edit) instead
    /// of a row of the history. stepsChanged() must be emitted when the answer changes.
    [[nodiscard]] virtual bool canTakeStepBack() const { return false; }
    virtual void takeStepBack() { }
    /// The name of that step in the text of undo.
    [[nodiscard]] virtual QString stepText() const { return tr("last corner"); }
    virtual void hover(const PointerSample&, const ViewContext&) { }
    virtual void leave() { } ///< the pointer left the view
    /// Handles a key press over a view; Esc is cancel(). @return whether the tool has used it
    virtual bool pressKey(int /*key*/) { return false; }
    /// Shift + wheel and [ ]: @p steps is positive for greater.
    virtual void changeRadius(int /*steps*/) { }
    /// Ctrl + Shift + wheel, in views that do not use it themselves.
    virtual void changeDepth(int /*steps*/) { }
    /// Whether the tool uses Ctrl + wheel in the 3D view, which the wheel alone also zooms.
    [[nodiscard]] virtual bool turns() const { return false; }
    /// Ctrl + wheel: @p steps is positive for counter-clockwise.
    virtual void turn(int /*steps*/) { }

    /// Draws what the tool will do, in every view where it works; the part at the cursor only in
    /// the view under the pointer.
    virtual void paintOverlay(QPainter&, const ViewContext&) const { }

Q_SIGNALS:
    void overlayChanged();
    void stepsChanged();
    void nameChanged(); ///< also hint and keys
};

} // namespace ui
