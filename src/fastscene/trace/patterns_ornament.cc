#include "fastscene/trace/kernel/ornament.h"
