// SPDX-License-Identifier: Apache-2.0
#include "core/base/files/StagedError.h"

#include "core/base/files/StagedFile.h"

#include <QFileInfo>

namespace core {

Error namingTarget(Error error, const StagedFile& staged)
{
    error.arguments.replace(staged.path(), staged.target());
    return error;
}

Error takingBack(Error error, StagedFile& staged)
{
    const QString left = staged.takeBack();
    if (!left.isEmpty())
        error.arguments.set(1,
            Clause::saying("%1; what was '%2' is in '%3' now", error.arguments.value(1),
                QFileInfo(staged.target()).fileName(), QFileInfo(left).fileName()));
    return error;
}

} // namespace core
