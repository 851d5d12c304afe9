// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <QString>
#include <QStringList>

#include <vector>

namespace test {

/// A process of this machine.
struct RunningProcess {
    qint64 pid = 0;
    qint64 parent = 0;
    QStringList words; ///< its command line
};

/// All whose command line can be read; none that has ended and waits for its parent.
[[nodiscard]] std::vector<RunningProcess> runningProcesses();
/// SIGSTOP. @return whether it stands still now, and has not ended before
[[nodiscard]] bool holdProcess(qint64 pid);

} // namespace test
