// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/base/Error.h"

#include <QString>

#include <memory>

class QWidget;

namespace core {
class Study;
}

namespace ui {

class MessageBar;
class StudyOpener;

// Dialogs that ask what is to be opened. The answer is passed to the opener.

void askForFolder(StudyOpener& opener, QWidget& parent);
void askForFile(StudyOpener& opener, QWidget& parent);
void askForSession(StudyOpener& opener, QWidget& parent);

/// Asks which volume of a study to open, and for a time series which point.
void chooseVolume(
    const std::shared_ptr<const core::Study>& study, StudyOpener& opener, QWidget& parent);

/// Asks for the voxel spacing of pictures that do not state it.
void askForSpacing(const std::shared_ptr<const core::Study>& study, const QString& series,
    StudyOpener& opener, QWidget& parent);

/// A session whose study was not found where it was expected.
struct LostStudy {
    QString sessionFile;
    QString format; ///< of the study
    core::Error why;
};
/// Shows this in the message bar, with a button to choose the place of the study. All arguments
/// outlive the message.
void offerToFindStudy(const LostStudy& lost, MessageBar& bar, StudyOpener& opener, QWidget& parent);

/// Connects the opener to these dialogs, so that each is shown when the opener needs its answer.
void answerQuestions(StudyOpener& opener, MessageBar& bar, QWidget& window);

} // namespace ui
