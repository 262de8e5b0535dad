#include "fastscene/trace/kernel/wood.h"
