module part;
int main() { return 0; }
