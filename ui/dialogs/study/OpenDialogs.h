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

// Where is what is to be opened? What the user names goes to the opener.

void askForFolder(StudyOpener& opener, QWidget& parent);
void askForFile(StudyOpener& opener, QWidget& parent);
void askForSession(StudyOpener& opener, QWidget& parent);

/// Which of a study's volumes, and of a series in time which point.
void chooseVolume(
    const std::shared_ptr<const core::Study>& study, StudyOpener& opener, QWidget& parent);

/// How far apart the voxels of pictures are that do not say so.
void askForSpacing(const std::shared_ptr<const core::Study>& study, const QString& series,
    StudyOpener& opener, QWidget& parent);

/// A session whose study is not where it was looked for.
struct LostStudy {
    QString sessionFile;
    QString format; ///< of the study
    core::Error why;
};
/// Says so in the bar, with a button to say where it is. All of them outlive the bar's message.
void offerToFindStudy(const LostStudy& lost, MessageBar& bar, StudyOpener& opener, QWidget& parent);

/// Asks all of that whenever the opener wants to know it.
void answerQuestions(StudyOpener& opener, MessageBar& bar, QWidget& window);

} // namespace ui
