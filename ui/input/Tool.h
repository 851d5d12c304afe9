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

/// One reading of mouse or pen, in the view's logical pixels (made in ui/input/StylusGlue only).
struct PointerSample {
    QPointF position;
    double pressure = 1.0; ///< 0 … 1; a mouse presses fully
    double timeSeconds = 0.0;
    Qt::KeyboardModifiers modifiers;
    bool eraserEnd = false;
    /// Of a pen: degrees from upright, positive to the right and towards the user. A mouse: 0.
    QPointF tiltDegrees;
    /// Of a pen about its own axis, clockwise; none: it does not tell.
    std::optional<double> rotationDegrees;
};

/// What the left button or the pen does now. By default it ignores everything; the view navigates
/// with the other buttons meanwhile. A stroke runs press → drag* → release | cancel.
class Tool : public QObject {
    Q_OBJECT

public:
    using QObject::QObject;

    [[nodiscard]] virtual QString name() const = 0; ///< short, under the icon: "Drill"
    [[nodiscard]] virtual QString iconName() const = 0; ///< resources/icons/<name>.svg
    [[nodiscard]] virtual QString hint() const = 0; ///< what it expects next, for the status line
    [[nodiscard]] virtual QString target() const { return {}; } ///< "carves layer Sculpt 1"
    [[nodiscard]] virtual QString keys() const { return {}; } ///< for the option bar's right end
    /// The tool's few options for the option bar; null: none. The parent owns it.
    [[nodiscard]] virtual QWidget* createOptions(QWidget* /*parent*/) { return nullptr; }
    /// What the tool itself holds that a session keeps (ToolSettings.h); empty: nothing.
    [[nodiscard]] virtual QJsonObject settingsJson() const { return {}; }
    /// Puts back what is there and makes sense.
    virtual void applySettings(const QJsonObject&) { }
    [[nodiscard]] virtual bool worksIn(const ViewContext& view) const = 0;

    /// Whether a press here is the tool's, in a view that it works in; else the view navigates.
    [[nodiscard]] virtual bool takes(const PointerSample&, const ViewContext&) const
    {
        return true;
    }

    virtual void press(const PointerSample&, const ViewContext&) { }
    virtual void drag(const PointerSample&, const ViewContext&) { }
    virtual void release(const PointerSample&, const ViewContext&) { }
    virtual void cancel() { }
    /// Something else is done: another tool is taken, another study opened, a step undone.
    virtual void putAway() { cancel(); }
    virtual void hover(const PointerSample&, const ViewContext&) { }
    virtual void leave() { } ///< the pointer left the view
    /// Shift + wheel and [ ]: @p steps is positive for greater.
    virtual void changeRadius(int /*steps*/) { }
    /// Alt + wheel.
    virtual void changeDepth(int /*steps*/) { }
    /// Alt + Shift + wheel: @p steps is positive for counter-clockwise.
    virtual void turn(int /*steps*/) { }

    /// What the tool will do, drawn over every view it works in; the cursor's part only where the
    /// pointer is.
    virtual void paintOverlay(QPainter&, const ViewContext&) const { }

Q_SIGNALS:
    void overlayChanged();
};

} // namespace ui
