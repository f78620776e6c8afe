# SPDX-FileCopyrightText: 2026 The Meniscus authors
# SPDX-License-Identifier: Apache-2.0
# The one Python that the package is built for and tested with.
#
# FindPython reads Python_EXECUTABLE, older modules PYTHON_EXECUTABLE: both are given the same, so that another Python
# earlier on the PATH is not taken for part of the work.
if(PYTHON_EXECUTABLE AND NOT Python_EXECUTABLE)
  set(Python_EXECUTABLE ${PYTHON_EXECUTABLE})
endif()
find_package(Python 3.9 REQUIRED COMPONENTS Interpreter Development.Module)
set(PYTHON_EXECUTABLE ${Python_EXECUTABLE})
set(PYBIND11_FINDPYTHON ON)
find_package(pybind11 2.10 REQUIRED)
