// SPDX-License-Identifier: Apache-2.0
#include "tests/support/faults/SmallFileSystem.h"

#include <cerrno>
#include <cstring>

#include <sched.h>
#include <sys/mount.h>

namespace test {

namespace {

/// Once a process: mounts of its own, of which the rest of the system sees nothing.
bool haveOwnMounts()
{
    static const bool own = unshare(CLONE_NEWNS) == 0
        && mount(nullptr, "/", nullptr, MS_REC | MS_PRIVATE, nullptr) == 0;
    return own;
}

QByteArray options(int kibibytes)
{
    return "size=" + QByteArray::number(kibibytes) + "k";
}

} // namespace

SmallFileSystem::SmallFileSystem(int kibibytes)
{
    if (!haveOwnMounts()
        || mount("tmpfs", m_folder.path().toLocal8Bit().constData(), "tmpfs", 0,
               options(kibibytes).constData())
            != 0)
        m_problem = QString::fromLocal8Bit(std::strerror(errno));
}

SmallFileSystem::~SmallFileSystem()
{
    if (m_problem.isEmpty())
        umount2(m_folder.path().toLocal8Bit().constData(), MNT_DETACH);
}

void SmallFileSystem::resize(int kibibytes)
{
    if (mount("tmpfs", m_folder.path().toLocal8Bit().constData(), "tmpfs", MS_REMOUNT,
            options(kibibytes).constData())
        != 0)
        qFatal("the small file system stays small: %s", std::strerror(errno));
}

} // namespace test
