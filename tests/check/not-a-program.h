; control: tnc640
#ifndef A_H
#define A_H
// a header
int add(int a, int b);
#endif
