// SPDX-License-Identifier: Apache-2.0
#include "ui/dialogs/SegmentDialogs.h"

#include "ui/dialogs/segment/BetweenSlicesDialog.h"
#include "ui/dialogs/segment/MirrorDialog.h"
#include "ui/dialogs/segment/ReshapeDialog.h"
#include "ui/dialogs/segment/SplitIslandsDialog.h"
#include "ui/dialogs/segment/ThresholdDialog.h"
#include "ui/workspace/Workspace.h"

namespace ui {

namespace {

template <class Dialog> Dialog& theDialog(Workspace& workspace, QWidget& window)
{
    auto* dialog = window.findChild<Dialog*>();
    return dialog ? *dialog : *new Dialog(workspace, &window);
}

} // namespace

void openSegmentDialogs(Workspace& workspace, QWidget& window)
{
    QObject::connect(&workspace, &Workspace::reshapeAsked, &window,
        [&workspace, &window](int label, core::ShapeOperation first) {
            theDialog<ReshapeDialog>(workspace, window).ask(label, first);
        });
    QObject::connect(
        &workspace, &Workspace::fillBetweenAsked, &window, [&workspace, &window](int label) {
            theDialog<BetweenSlicesDialog>(workspace, window).ask(label);
        });
    QObject::connect(
        &workspace, &Workspace::mirrorAsked, &window, [&workspace, &window](int label) {
            theDialog<MirrorDialog>(workspace, window).ask(label);
        });
    QObject::connect(
        &workspace, &Workspace::splitIslandsAsked, &window, [&workspace, &window](int label) {
            theDialog<SplitIslandsDialog>(workspace, window).ask(label);
        });
    QObject::connect(
        &workspace, &Workspace::thresholdAsked, &window, [&workspace, &window](int label) {
            theDialog<ThresholdDialog>(workspace, window).ask(label);
        });
}

} // namespace ui
