// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/base/Background.h"
#include "core/growth/SketchInterval.h"

#include <QObject>

#include <cstdint>
#include <memory>
#include <vector>

namespace ui {

class Workspace;

/// Finds out which values lie under and around sketches (core/growth/SketchInterval.h). The engine
/// reads the voxels and a background thread evaluates them, so the window does not wait. GUI
/// thread.
class SketchLook : public QObject {
    Q_OBJECT

public:
    explicit SketchLook(Workspace& workspace, QObject* parent = nullptr);

    /// Asks about some sketches; the answer comes by found(). An earlier question is dropped.
    void ask(std::vector<core::SeedSketch> sketches);
    /// Drops the question. To be called when another session is opened.
    void drop();

Q_SIGNALS:
    /// The answer to the last question.
    /// @param seeds codes of all sketched voxels, in the order of the question
    void found(const core::SketchedCodes& sketched, const std::vector<int>& seeds);

private:
    struct Question;
    void read(std::shared_ptr<const Question> question);
    void look(std::shared_ptr<const Question> question, std::vector<int> codes);

    Workspace& m_workspace;
    std::uint64_t m_asked = 0; ///< number of questions so far; answers to earlier ones are ignored
    core::Background m_background;
};

} // namespace ui
