// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <QFile>
#include <QString>

namespace app {

/// That a window is open, and why it ended: a file in the user's state folder that is locked as
/// long as the window lives, and gone when it is closed. What one leaves that was not closed is
/// told by the next. Holds one word, nothing of any study.
class EndNote {
public:
    static constexpr const char* outOfMemory = "memory";
    static constexpr const char* crashed = "crash";

    /// Where no note can be made there is none.
    EndNote();
    ~EndNote();
    EndNote(const EndNote&) = delete;
    EndNote& operator=(const EndNote&) = delete;

    /// How the windows before ended that were not closed, as a sentence; told once. Empty: they
    /// were.
    [[nodiscard]] static QString takeEarlier();

private:
    QFile m_file;
};

} // namespace app
